// SPDX-License-Identifier: GPL-3.0-or-later
// The liner between the members of its lattice.
#pragma once

#include "checks/check_finding.h"
#include "checks/loaded_segment.h"

namespace latticast {

/// Adds the findings liner-balloons, liner-bulges, rings-too-far.
void check_bulging(const LoadedSegment& loaded, CheckFindings& findings);

}  // namespace latticast
