// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "model/equilibrium/law_limits.h"
#include "model/equilibrium/state_error.h"

namespace latticast {
namespace {

constexpr double path_accuracy = 1e-7;
constexpr double near_its_bound = 0.01;  // of an asymptote's pressure, what may be left
constexpr double extremum_goal = 1e-9;   // of the state at an angle extremum

// Where an energy is another's to second order about its anchor: how far from there it is good
// enough, as a share of the step and within bounds, and how often it may be anchored anew.
constexpr double anchored_share = 0.02;
constexpr double least_anchored = 1e-6;
constexpr double most_anchored = 1e-3;
constexpr int most_anchors = 6;

}  // namespace

Branch::Branch(const Section& section, Held held, const SolverOptions& options, EnergySource source)
    : balance_(section, held, options, std::move(source)),
      options_(options),
      n_(balance_.free_count()),
      newton_(n_ + 1) {
  restart();
}

void Branch::restart() {
  const BranchPoint rest{};
  if (!balance_.anchor_at(rest)) throw std::runtime_error("a segment cannot be solved at rest");
  here_ = examined(equations_of(balance_), rest, *balance_.at(rest), load_axis(n_));
  here_.anchor = balance_.anchor();
  step_length_ = first_step;
  critical_points_.clear();
  angle_extrema_.clear();
}

std::optional<BranchState> Branch::correct(const BranchPoint& start, const BranchPoint& normal) {
  if (balance_.has_source()) return correct_anchored(start, normal);
  auto state = corrected(equations_of(balance_), newton_, start, normal, here_.tangent);
  iterations_ += newton_.iterations();
  return state;
}

/// Anchors the energy where the equilibrium is, as often as that still moves it.
std::optional<BranchState> Branch::correct_anchored(const BranchPoint& start,
                                                    const BranchPoint& normal) {
  const EquilibriumEquations equations = equations_of(balance_);
  if (balance_.distance_from(*here_.anchor, start) <
      balance_.distance_from(*balance_.anchor(), start)) {
    balance_.return_to(here_.anchor);
  }
  const double step = distance(start, here_.x);
  const double reach = 2 * greatest_contraction * std::max(step, first_step);
  const double anchored = std::clamp(anchored_share * step, least_anchored, most_anchored);
  BranchPoint from = start;
  for (int anchors = 0; anchors <= most_anchors; ++anchors) {
    auto state = corrected(equations, newton_, from, normal, here_.tangent);
    iterations_ += newton_.iterations();
    // A correction that would not count is not worth what its energy costs.
    if (!state || distance(state->x, start) > reach) return std::nullopt;
    if (balance_.distance_from(*balance_.anchor(), state->x) <= anchored) {
      state->anchor = balance_.anchor();
      return state;
    }
    if (!balance_.anchor_at(state->x)) return std::nullopt;
    from = state->x;
  }
  return std::nullopt;
}

CorrectInPlane Branch::in_plane() {
  return [this](const BranchPoint& start, const BranchPoint& normal) {
    return correct(start, normal);
  };
}

BranchStep Branch::try_step(double length, bool landing, double target) {
  BranchPoint start = here_.x;
  for (int i = 0; i <= n_; ++i) start[i] += length * here_.tangent[i];
  if (landing) start[n_] = target;
  return judged_step(here_, start, correct(start, landing ? load_axis(n_) : here_.tangent), n_);
}

Reached Branch::advance_to(double pressure_mpa) {
  const double target = balance_.scaled_pressure(pressure_mpa);
  if (target == here_.x[n_]) return Reached::target;
  const double sign = target > here_.x[n_] ? 1 : -1;
  // Only at rest can the tangent still point the other way.
  if (here_.tangent[n_] * sign < 0) {
    for (double& t : here_.tangent) t = -t;
  }
  if (is_beyond_end(target, sign)) return Reached::end;
  while (true) {
    const Reached reached = follow_to(target, sign);
    // Close to a rubber's stretch limit a coarse quadrature loses its solution before a fine one
    // does.
    const bool final =
        reached != Reached::lost || at_law_end(balance_, here_.x) || has_grown_away();
    if (final || !refine_here()) return reached;
    step_length_ = first_step;
  }
}

Reached Branch::follow_to(double target, double sign) {
  for (int count = 0; count < options_.most_steps && step_length_ > smallest_step; ++count) {
    if (at_law_end(balance_, here_.x)) return Reached::lost;
    if (const auto reached = advance(target, sign)) return *reached;
  }
  return Reached::lost;
}

/// One step toward `target`. Empty when the branch is to be followed on from here(), which has
/// moved or is to try a shorter step.
std::optional<Reached> Branch::advance(double target, double sign) {
  step_length_ = length_within_laws(balance_, here_.x, here_.tangent, step_length_);
  const double to_target = (target - here_.x[n_]) / here_.tangent[n_];
  const bool landing = to_target <= step_length_;
  const double length = landing ? to_target : step_length_;
  const auto [state, contraction, accepted] = try_step(length, landing, target);
  if (!accepted || (!landing && (state.x[n_] - target) * sign > 0)) {
    step_length_ = shortened(length, contraction);
    return std::nullopt;
  }
  if (state.tangent[n_] * sign <= 0) {
    const auto reached = turned_back(state, target, sign);
    if (!reached) step_length_ = 0.5 * length;
    return reached;
  }
  // A crossing that cannot be pinned down between here and there is a step to another branch.
  if (state.negative_eigenvalues != here_.negative_eigenvalues && !note_bifurcation_before(state)) {
    step_length_ = 0.5 * length;
    return std::nullopt;
  }
  if (state.x[n_ - 1] < closed_bore) return note_closure(state);
  note_angle_extrema_before(state);
  return settle(state, landing, lengthened(length, contraction));
}

/// Moves here to an equilibrium that counts.
std::optional<Reached> Branch::settle(const BranchState& state, bool landing, double next_length) {
  here_ = state;
  if (at_law_end(balance_, here_.x)) return Reached::lost;
  step_length_ = std::min(landing ? std::max(step_length_, next_length) : next_length,
                          longest_step(here_.x, n_));
  if (landing) return finish_landing();
  // The path must be the section's own, not a coarse quadrature's.
  refine_to(path_accuracy);
  if (largest_growth(here_.x, n_) > endless_growth) return end_of_growth();
  return std::nullopt;
}

/// The branch turns back on the way to `beyond`: looks for the limit point, and lands if the target
/// comes first.
std::optional<Reached> Branch::turned_back(const BranchState& beyond, double target, double sign) {
  // So far out the slope of the pressure is below rounding.
  if (has_grown_away()) return end_of_growth();
  const auto limit = limit_point_before(beyond);
  if (!limit) return std::nullopt;
  if ((limit->x[n_] - target) * sign <= 0) return end_at(*limit);
  const auto landed = landed_before(here_, limit->x, target, n_, in_plane());
  if (!landed) return std::nullopt;
  here_ = *landed;
  return finish_landing();
}

Reached Branch::end_at(const CriticalState& end) {
  critical_points_.push_back(end);
  return Reached::end;
}

bool Branch::is_beyond_end(double target, double sign) const {
  if (critical_points_.empty()) return false;
  const CriticalState& last = critical_points_.back();
  return last.kind != CriticalKind::bifurcation && (last.x[n_] - target) * sign <= 0;
}

bool Branch::has_grown_away() const {
  return largest_growth(here_.x, n_) > 0.1 * endless_growth;
}

/// Where the pressure still rises noticeably, it has no bound that could be named.
Reached Branch::end_of_growth() {
  const CriticalState asymptote = asymptote_at(here_, n_);
  return asymptote.pressure_error < near_its_bound ? end_at(asymptote) : Reached::lost;
}

std::optional<CriticalState> Branch::limit_point_before(const BranchState& beyond) {
  if (balance_.has_source()) {
    return limit_point_between(equations_of(balance_), here_, beyond, in_plane());
  }
  if (!limit_newton_) limit_newton_.emplace(limit_point_unknowns(n_));
  BranchPoint guess = limit_point_guess(here_, beyond);
  while (true) {
    const auto found = locate_limit_point(equations_of(balance_), *limit_newton_, guess);
    iterations_ += limit_newton_->iterations();
    if (!found || !lies_between(found->x, here_, beyond)) return std::nullopt;
    if (found->pressure_error <= options_.error_goal || !balance_.refine(found->x)) {
      return is_connected(here_, found->x, n_, in_plane()) ? found : std::nullopt;
    }
    guess = found->x;
  }
}

bool Branch::note_bifurcation_before(const BranchState& beyond) {
  const auto bifurcation = bifurcation_between(here_, beyond, n_, in_plane());
  if (bifurcation) critical_points_.push_back(*bifurcation);
  return bifurcation.has_value();
}

/// A path good to `path_accuracy` is not enough here: the quadrature is refined until the extrema
/// are good.
void Branch::note_angle_extrema_before(const BranchState& beyond) {
  const auto equilibrium = [&](const BranchPoint& start) { return correct(start, load_axis(n_)); };
  while (true) {
    std::vector<ExtremumState> found = angle_extrema_between(balance_, here_, beyond, equilibrium);
    double worst = 0;
    for (ExtremumState& extremum : found) {
      const double error = state_error(balance_, extremum.x, extremum.balance);
      extremum.pressure_error = std::max(extremum.pressure_error, error);
      worst = std::max(worst, error);
    }
    if (worst > extremum_goal && balance_.refine(beyond.x)) continue;
    angle_extrema_.insert(angle_extrema_.end(), found.begin(), found.end());
    return;
  }
}

/// Lands on the closed bore between here and a state past it.
Reached Branch::note_closure(const BranchState& beyond) {
  BranchPoint start = closure_guess(here_, beyond, n_);
  while (true) {
    const auto closed = closed_from(start, n_, in_plane());
    const auto finer = closed ? balance_.finer_at(closed->x) : std::nullopt;
    if (!finer) return Reached::lost;
    const double error = closure_error(*closed, *finer, n_);
    if (error <= options_.error_goal || !balance_.refine(closed->x)) {
      return end_at({CriticalKind::closure, closed->x, closed->balance, error});
    }
    start = closed->x;
  }
}

/// Takes a finer quadrature and moves here to its equilibrium at the same pressure.
bool Branch::refine_here() {
  if (!balance_.refine(here_.x)) return false;
  const auto refined = correct(here_.x, load_axis(n_));
  if (refined) here_ = *refined;
  return refined.has_value();
}

/// Refines the quadrature until the state here is good to `goal`, or rounding lets it get no
/// better.
void Branch::refine_to(double goal) {
  here_.error_estimate = state_error(balance_, here_.x, here_.balance);
  double before = std::numeric_limits<double>::infinity();
  while (here_.error_estimate > goal && here_.error_estimate < 0.9 * before) {
    before = here_.error_estimate;
    if (!refine_here()) break;
    here_.error_estimate = state_error(balance_, here_.x, here_.balance);
  }
}

Reached Branch::finish_landing() {
  refine_to(options_.error_goal);
  return Reached::target;
}

}  // namespace latticast
