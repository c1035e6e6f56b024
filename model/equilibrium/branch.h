// SPDX-License-Identifier: GPL-3.0-or-later
// Branch of equilibria under rising or falling pressure, by pseudo-arclength continuation
// ([Keller 1977]) from the rest state.
#pragma once

#include <optional>
#include <vector>

#include "model/equilibrium/balance.h"
#include "model/equilibrium/limit_point.h"
#include "model/numerics/newton.h"

namespace latticast {

/// An equilibrium on the branch with what is needed to go on from it.
struct BranchState {
  BranchPoint x{};
  BalanceAt balance;
  BranchPoint tangent{};           ///< unit vector along the branch, in the direction of travel
  double smallest_eigenvalue = 0;  ///< of the scaled stiffness of all free coordinates
  int negative_eigenvalues = 0;
  double nearest_eigenvalue = 0;         ///< the one nearest to zero
  double nearest_solved_eigenvalue = 0;  ///< the same, among the coordinates solved for
  double error_estimate = 0;             ///< set where a requested pressure was landed on
};

enum class Reached { target, end, lost };

/// Pseudo-arclength continuation, [Keller 1977]: predict along the tangent, correct by
/// Newton's method square to it, land on a requested pressure by correcting at that pressure. A
/// step counts only if the correction is small against it, the tangent turns little, and the
/// pressure does not seem to turn back and forth in between; otherwise it is shortened.
class Branch {
 public:
  Branch(const Section& section, Held held, const SolverOptions& options);

  /// Back to the rest state, which is exact.
  void restart();

  /// Follows the branch on to `pressure_mpa`. Between two calls of restart() pressures must go away
  /// from zero. After `end` (no equilibrium at that pressure) or `lost` (the path could not be
  /// followed), here() is the last equilibrium before.
  Reached advance_to(double pressure_mpa);

  const BranchState& here() const { return here_; }
  const Balance& balance() const { return balance_; }

  /// Critical points met since restart(), in that order; all but a bifurcation end the branch.
  const std::vector<CriticalState>& critical_points() const { return critical_points_; }

  /// Extrema of bending and twist met since restart(), in that order.
  const std::vector<ExtremumState>& angle_extrema() const { return angle_extrema_; }

  /// Newton iterations since construction.
  int iterations() const { return iterations_; }

 private:
  struct Step {
    BranchState state;
    double contraction = 0;  // of the Newton correction against the step
    bool accepted = false;
  };

  std::optional<BranchState> corrected(const BranchPoint& start, const BranchPoint& normal);
  Step try_step(const BranchPoint& start, const BranchPoint& normal);
  double movement(const BranchPoint& a, const BranchPoint& b) const;
  BranchPoint ahead(double length) const;
  BranchPoint pressure_axis() const;
  BranchPoint at_pressure(double pressure, BranchPoint x) const;
  Reached follow_to(double target, double sign);
  bool at_end(double target, double sign) const;
  bool at_law_end() const;
  double within_laws(double length) const;
  bool is_connected(const BranchPoint& limit);
  Reached end_at(const CriticalState& end);
  double largest_growth() const;
  double longest_step() const;
  bool has_grown_away() const;
  Reached end_of_growth();
  CriticalState asymptote_here() const;
  bool land_before(const CriticalState& limit, double target);
  std::optional<CriticalState> limit_point_before(const BranchState& beyond);
  std::optional<CriticalState> bifurcation_before(const BranchState& beyond);
  bool note_bifurcation_before(const BranchState& beyond);
  void note_angle_extrema_before(const BranchState& beyond);
  void examine_stability(BranchState& state) const;
  Reached note_closure(const BranchState& beyond);
  bool refine_here();
  double error_at(const BranchPoint& x, const BalanceAt& balance) const;
  void refine_to(double goal);
  Reached finish_landing();

  Balance balance_;
  SolverOptions options_;
  int n_;  // free coordinates; the pressure is entry n_ of a point
  NewtonSolver newton_;
  std::optional<NewtonSolver> limit_newton_;  // made when first needed
  BranchState here_;
  double step_length_ = 0;  // arc length that the next step may try
  std::vector<CriticalState> critical_points_;
  std::vector<ExtremumState> angle_extrema_;
  int iterations_ = 0;
};

}  // namespace latticast
