// SPDX-License-Identifier: GPL-3.0-or-later
// Limit point of a branch of equilibria, by the extended system of [Moore 1980].
#pragma once

#include <optional>

#include "model/equilibrium/balance.h"
#include "model/numerics/newton.h"

namespace latticast {

/// A point where a branch ends or loses stability.
struct CriticalState {
  CriticalKind kind = CriticalKind::limit_point;
  BranchPoint x{};
  BalanceAt balance;
  double pressure_error = 0;  ///< estimated, relative to the pressure
  int iterations = 0;         ///< Newton iterations spent on it
};

/// Where the bending or the twist is largest or smallest along a branch that goes on.
struct ExtremumState {
  bool of_bending = false;
  bool largest = true;
  BranchPoint x{};
  BalanceAt balance;
  double pressure_error = 0;  ///< estimated, relative to the pressure
};

/// Size of the system that `locate_limit_point` solves, for its NewtonSolver.
inline int limit_point_unknowns(const Balance& balance) {
  return 2 * balance.free_count() + 1;
}

/// Solves the extended system of a limit point, [Moore 1980],
///     dPi/dq = 0,  H v = 0,  v . v = 1
/// from a guess near it. Empty when Newton's method does not converge; that the result belongs to
/// the branch in question is for the caller to check.
std::optional<CriticalState> locate_limit_point(const Balance& balance, NewtonSolver& newton,
                                                const BranchPoint& guess);

}  // namespace latticast
