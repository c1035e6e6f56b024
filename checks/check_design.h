// SPDX-License-Identifier: GPL-3.0-or-later
// All checks of a design together.
#pragma once

#include "checks/check_finding.h"

namespace latticast {

struct Design;
struct PreparedDesign;

/// Which of a design's checks to run.
struct CheckScope {
  bool printing = true;
  bool casting = true;
  bool inflating = true;
};

/// Everything in the scope that this build can check: printing with LATTICAST_GEOMETRY, casting
/// with LATTICAST_MOLDS, inflating with LATTICAST_PREDICT. A design that cannot be drawn, molded or
/// predicted gets a finding that says so, not an exception.
/// What `prepared` lacks is computed and left in it. `design` is the one that it was made for, or
/// that one with less under [make].
CheckFindings check_design(const Design& design, PreparedDesign& prepared,
                           const CheckScope& scope = {});

/// Of a design that nobody else needs prepared.
CheckFindings check_design(const Design& design);

}  // namespace latticast
