// SPDX-License-Identifier: GPL-3.0-or-later
// Limit point of a branch of equilibria, by the extended system of [Moore 1980].
#pragma once

#include <optional>

#include "model/equilibrium/branch_state.h"
#include "model/equilibrium/response.h"
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

/// Size of the system that `locate_limit_point` solves, for its NewtonSolver.
inline int limit_point_unknowns(int size) {
  return 2 * size + 1;
}

/// Solves the extended system of a limit point, [Moore 1980],
///     dPi/dq = 0,  H v = 0,  v . v = 1
/// from a guess near it. Empty when Newton's method does not converge; that the result belongs to
/// the branch in question is for the caller to check.
std::optional<CriticalState> locate_limit_point(const EquilibriumEquations& equations,
                                                NewtonSolver& newton, const BranchPoint& guess);

}  // namespace latticast
