// SPDX-License-Identifier: GPL-3.0-or-later
// States of a branch of equilibria: a point with its tangent and its stability, and the geometry of
// such points.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "model/equilibrium/balance.h"
#include "model/numerics/newton.h"

namespace latticast {

/// What a branch is followed by: `size` free coordinates and their equations under a load, which is
/// entry `size` of a point. Balance gives those of a section.
struct EquilibriumEquations {
  int size = 0;

  /// Empty where a state cannot exist.
  std::function<std::optional<BalanceAt>(std::span<const double> x)> at;

  /// The same with a smaller error, by which errors are measured.
  std::function<std::optional<BalanceAt>(std::span<const double> x)> finer_at;

  std::function<SuppressedModes(std::span<const double> x)> suppressed_modes;
};

/// Of a section; `balance` must outlive them.
EquilibriumEquations equations_of(const Balance& balance);

/// An equilibrium on the branch with what is needed to go on from it.
struct BranchState {
  BranchPoint x{};
  BalanceAt balance;
  BranchPoint tangent{};           ///< unit vector along the branch, in the direction of travel
  double smallest_eigenvalue = 0;  ///< of the scaled stiffness of all free coordinates
  int negative_eigenvalues = 0;
  double nearest_eigenvalue = 0;               ///< the one nearest to zero
  double nearest_solved_eigenvalue = 0;        ///< the same, among the coordinates solved for
  double error_estimate = 0;                   ///< set where a requested pressure was landed on
  std::shared_ptr<const EnergyAnchor> anchor;  ///< under which it is an equilibrium; mostly null
};

/// The equilibrium at `x`, which must be one, its tangent on the side of `guide`.
BranchState examined(const EquilibriumEquations& equations, const BranchPoint& x,
                     const BalanceAt& balance, const BranchPoint& guide);

/// The equilibrium in the plane through `start` with the given normal, by Newton's method from
/// `start`: the normal along the branch makes an arc-length step, along the load it prescribes the
/// load. Empty without convergence in 12 iterations.
std::optional<BranchState> corrected(const EquilibriumEquations& equations, NewtonSolver& newton,
                                     const BranchPoint& start, const BranchPoint& normal,
                                     const BranchPoint& guide);

/// Change of a point, load included, that makes good a residual in the plane with this normal.
BranchPoint correction(const BalanceAt& balance, const BalanceAt::Vector& residual,
                       const BranchPoint& normal, int size);

double dot(const BranchPoint& a, const BranchPoint& b);
double distance(const BranchPoint& a, const BranchPoint& b);
BranchPoint between(const BranchPoint& a, const BranchPoint& b, double fraction);
BranchPoint at_load(BranchPoint x, double load, int size);

/// Unit vector along the load.
BranchPoint load_axis(int size);

/// How far the coordinates of two points are apart, whatever their loads.
double movement(const BranchPoint& a, const BranchPoint& b, int size);

/// The largest coordinate.
double largest_growth(const BranchPoint& x, int size);

}  // namespace latticast
