// SPDX-License-Identifier: GPL-3.0-or-later
// The checks that come before a build.
#pragma once

#include "app/console.h"
#include "checks/check_finding.h"

namespace latticast {

struct Plan;
struct PreparedDesign;

/// What can go wrong with the parts that the plan makes, and no others: printing for a lattice or
/// its mold, casting for molds, the whole load for a preview. A report lists all that the design
/// has.
CheckFindings checks_before_build(PreparedDesign& prepared, const Plan& plan);

/// Writes the errors for people, each with its place and remedy, and counts the warnings and notes;
/// true when the build may go on: nothing was found that spoils a part, or `force` is set.
bool may_build(const CheckFindings& findings, bool force, const Console& console);

}  // namespace latticast
