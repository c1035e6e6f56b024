// SPDX-License-Identifier: GPL-3.0-or-later
// Extrema of the bending and twist angles along a branch, where the sign of their rate changes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/equilibrium/branch.h"

namespace latticast {

/// The equilibrium at the pressure of `start`, found from there; empty when there is none close by.
using EquilibriumNear = std::function<std::optional<BranchState>(const BranchPoint& start)>;

/// Whether a slope of equal sign at both ends of a step may change its sign in between, twice: the
/// quadratic through the end slopes and their mean over the step sinks to half of the lesser one.
bool slope_may_vanish(double start, double end, double mean);

/// Extrema of bending and twist between two successive states of a branch, in the order of
/// travel. Where a rate has one sign at both ends but may vanish in between, the step is halved and
/// looked at again, six times at most. A twist or a one-sided bending that passes through zero does
/// not turn there; a bending that passes zero at some distance has its smallest value there.
std::vector<ExtremumState> angle_extrema_between(const Balance& balance, const BranchState& from,
                                                 const BranchState& to,
                                                 const EquilibriumNear& equilibrium);

}  // namespace latticast
