// SPDX-License-Identifier: GPL-3.0-or-later
// Branch of equilibria under rising or falling pressure, by pseudo-arclength continuation
// ([Keller 1977]) from the rest state.
#pragma once

#include <optional>
#include <vector>

#include "model/equilibrium/angle_extremum.h"
#include "model/equilibrium/balance.h"
#include "model/equilibrium/branch_events.h"
#include "model/equilibrium/step_control.h"
#include "model/numerics/newton.h"

namespace latticast {

enum class Reached { target, end, lost };

/// Pseudo-arclength continuation, [Keller 1977]: predict along the tangent, correct by Newton's
/// method square to it, land on a requested pressure by correcting at that pressure. Which steps
/// count: judged_step. What is looked for in each: model/equilibrium/branch_events.h.
class Branch {
 public:
  Branch(const Section& section, Held held, const SolverOptions& options, EnergySource source = {});

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
  std::optional<BranchState> correct(const BranchPoint& start, const BranchPoint& normal);
  std::optional<BranchState> correct_anchored(const BranchPoint& start, const BranchPoint& normal);
  CorrectInPlane in_plane();
  BranchStep try_step(double length, bool landing, double target);
  Reached follow_to(double target, double sign);
  std::optional<Reached> advance(double target, double sign);
  std::optional<Reached> turned_back(const BranchState& beyond, double target, double sign);
  std::optional<Reached> settle(const BranchState& state, bool landing, double next_length);
  Reached end_at(const CriticalState& end);
  bool is_beyond_end(double target, double sign) const;
  bool has_grown_away() const;
  Reached end_of_growth();
  std::optional<CriticalState> limit_point_before(const BranchState& beyond);
  bool note_bifurcation_before(const BranchState& beyond);
  void note_angle_extrema_before(const BranchState& beyond);
  Reached note_closure(const BranchState& beyond);
  bool refine_here();
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
