// SPDX-License-Identifier: GPL-3.0-or-later
// All checks of a design together.
#pragma once

#include "checks/check_finding.h"
#include "design/design.h"

namespace latticast {

/// Which of a design's checks to run.
struct CheckScope {
  bool printing = true;
  bool casting = true;
  bool inflating = true;
};

/// Everything in the scope that this build can check: printing with LATTICAST_GEOMETRY, casting
/// with LATTICAST_MOLDS, inflating with LATTICAST_PREDICT. A design that cannot be drawn, molded or
/// predicted gets a finding that says so, not an exception.
CheckFindings check_design(const Design& design, const CheckScope& scope = {});

}  // namespace latticast
