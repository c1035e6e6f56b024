// SPDX-License-Identifier: GPL-3.0-or-later
// A design's intermediate results, each computed at first demand and kept for the stages that
// follow: drawn and united lattices, molds, sections and responses.
#pragma once

#include "design/design.h"
#if LATTICAST_HAS_GEOMETRY
#include "prepared/prepared_lattices.h"
#endif
#if LATTICAST_HAS_MOLDS
#include "prepared/prepared_molds.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "prepared/prepared_responses.h"
#endif

namespace latticast {

/// For one thread at a time. Keeps a reference to the design, which must outlive it unchanged. What
/// a member returns stays until this is destroyed; what throws is tried again at the next demand.
struct PreparedDesign {
  explicit PreparedDesign(const Design& from);
  PreparedDesign(const PreparedDesign&) = delete;
  PreparedDesign& operator=(const PreparedDesign&) = delete;

  const Design& design;
#if LATTICAST_HAS_GEOMETRY
  PreparedLattices lattices;
#endif
#if LATTICAST_HAS_MOLDS
  PreparedMolds molds;
#endif
#if LATTICAST_HAS_PREDICT
  PreparedResponses responses;
#endif
};

}  // namespace latticast
