// SPDX-License-Identifier: GPL-3.0-or-later
// Extrema of the bending and twist angles along a branch, where the sign of their rate changes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/equilibrium/balance.h"
#include "model/equilibrium/branch_state.h"

namespace latticast {

/// The equilibrium at the pressure of `start`, found from there; empty when there is none close by.
using EquilibriumNear = std::function<std::optional<BranchState>(const BranchPoint& start)>;

/// Where the bending or the twist is largest or smallest along a branch that goes on.
struct ExtremumState {
  bool of_bending = false;
  bool largest = true;
  BranchPoint x{};
  BalanceAt balance;
  double pressure_error = 0;  ///< estimated, relative to the pressure
};

/// Extrema of bending and twist between two successive states of a branch, in the order of
/// travel. Where a rate has one sign at both ends but may vanish in between, the step is halved and
/// looked at again, six times at most. A twist or a one-sided bending that passes through zero does
/// not turn there; a bending that passes zero at some distance has its smallest value there.
std::vector<ExtremumState> angle_extrema_between(const Balance& balance, const BranchState& from,
                                                 const BranchState& to,
                                                 const EquilibriumNear& equilibrium);

}  // namespace latticast
