// SPDX-License-Identifier: GPL-3.0-or-later
// Ballooning, buckling, and a path of equilibria that ends.
#pragma once

#include "checks/check_finding.h"
#include "checks/loaded_segment.h"

namespace latticast {

/// Adds the findings limit-point, limit-point-near, unstable-state, not-followed.
void check_stability(const LoadedSegment& loaded, CheckFindings& findings);

}  // namespace latticast
