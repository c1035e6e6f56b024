// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/equilibrium/angle_extremum.h"
#include "model/numerics/small_matrix.h"
#include "model/section/section_energy.h"

namespace latticast {
namespace {

/// Room for the free coordinates and the pressure.
using BorderedMatrix = std::array<double, (coordinate_count + 1) * (coordinate_count + 1)>;
static_assert(coordinate_count + 1 <= largest_matrix);

constexpr int most_iterations = 12;
constexpr double first_step = 0.3;
constexpr double smallest_step = 1e-10;
constexpr double path_accuracy = 1e-7;
constexpr double endless_growth = 1e3;          // of a scaled coordinate, whose order is 1
constexpr double near_its_bound = 0.01;         // of an asymptote's pressure, what may be left
constexpr double bifurcation_accuracy = 1e-12;  // of its pressure, relative
constexpr double extremum_goal = 1e-9;          // of the state at an angle extremum
constexpr double closed_bore = -0.999;          // a/R_i - 1, always the last free coordinate
constexpr double wanted_contraction =
    0.08;  // correction against step that a step is chosen for ...
constexpr double greatest_contraction = 0.15;  // ... and beyond which it does not count
constexpr double least_alignment = 0.95;       // cosine between successive tangents
constexpr double law_end = 1e-6;  // room in a horseshoe's law, relative, that counts as none
constexpr int limit_checks = 8;   // parts of the way to a limit point

double dot(const BranchPoint& a, const BranchPoint& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double distance(const BranchPoint& a, const BranchPoint& b) {
  BranchPoint apart{};
  for (std::size_t i = 0; i < a.size(); ++i) apart[i] = a[i] - b[i];
  return std::sqrt(dot(apart, apart));
}

BranchPoint between(const BranchPoint& a, const BranchPoint& b, double fraction) {
  BranchPoint x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = a[i] + fraction * (b[i] - a[i]);
  return x;
}

/// Of the symmetric n x n stiffness, rising.
BalanceAt::Vector stiffness_eigenvalues(const BalanceAt& balance, int n) {
  BalanceAt::Matrix stiffness = balance.tangent_stiffness;
  BalanceAt::Vector values{};
  symmetric_eigenvalues(std::span(stiffness).first(n * n), std::span(values).first(n));
  return values;
}

/// Derivatives of the residual by coordinates and pressure, closed by a plane's normal: regular
/// also where the stiffness alone is singular.
void fill_bordered(std::span<double> matrix, const BalanceAt& balance, const BranchPoint& normal,
                   int n) {
  for (int j = 0; j < n; ++j) {
    std::copy_n(&balance.tangent_stiffness[j * n], n, &matrix[j * (n + 1)]);
    matrix[n * (n + 1) + j] = -balance.load_vector[j];
  }
  for (int j = 0; j <= n; ++j) matrix[j * (n + 1) + n] = normal[j];
}

/// Solves the bordered system; `right` becomes its solution.
void solve_bordered(const BalanceAt& balance, const BranchPoint& normal, BranchPoint& right,
                    int n) {
  BorderedMatrix matrix;
  fill_bordered(matrix, balance, normal, n);
  solve_in_place(std::span(matrix).first((n + 1) * (n + 1)), std::span(right).first(n + 1));
}

/// The direction in which the residual stays zero, on the side of `guide`.
BranchPoint tangent_at(const BalanceAt& balance, const BranchPoint& guide, int n) {
  BranchPoint tangent{};
  tangent[n] = 1;
  solve_bordered(balance, guide, tangent, n);
  const double length = norm(tangent);
  for (double& entry : tangent) entry /= length;
  return tangent;
}

/// What is left of a horseshoe's law on the way to its nearer end: 1 at rest, 0 there, and below 0
/// past it. Empty without horseshoes, or where the state cannot exist.
std::optional<double> room_in_laws(const Balance& balance, const BranchPoint& x) {
  const auto horseshoe = most_strained_horseshoe(balance.section(), balance.deformation(x));
  if (!horseshoe) return std::nullopt;
  const StrainRange& range = horseshoe->range;
  return std::min(1 - horseshoe->strain / range.lowest, 1 - horseshoe->strain / range.highest);
}

/// Whether the pressure between two states may turn back and forth again.
bool may_turn_between(const BranchState& a, const BranchState& b, int n) {
  const double mean = (b.x[n] - a.x[n]) / distance(a.x, b.x);
  return slope_may_vanish(a.tangent[n], b.tangent[n], mean);
}

}  // namespace

Branch::Branch(const Section& section, Held held, const SolverOptions& options)
    : balance_(section, held, options),
      options_(options),
      n_(balance_.free_count()),
      newton_(n_ + 1) {
  restart();
}

void Branch::restart() {
  here_ = {};
  here_.balance = *balance_.at(here_.x);
  examine_stability(here_);
  here_.tangent = tangent_at(here_.balance, pressure_axis(), n_);
  step_length_ = first_step;
  critical_points_.clear();
  angle_extrema_.clear();
}

void Branch::examine_stability(BranchState& state) const {
  const BalanceAt::Vector values = stiffness_eigenvalues(state.balance, n_);
  state.smallest_eigenvalue = state.nearest_eigenvalue = values[0];
  state.negative_eigenvalues = 0;
  for (int i = 0; i < n_; ++i) {
    if (std::abs(values[i]) < std::abs(state.nearest_eigenvalue)) {
      state.nearest_eigenvalue = values[i];
    }
    if (values[i] < 0) ++state.negative_eigenvalues;
  }
  state.nearest_solved_eigenvalue = state.nearest_eigenvalue;
  const SuppressedModes suppressed = balance_.suppressed_modes(state.x);
  for (int i = 0; i < suppressed.count; ++i) {
    const double value = suppressed.eigenvalues[i];
    state.smallest_eigenvalue = std::min(state.smallest_eigenvalue, value);
    if (std::abs(value) < std::abs(state.nearest_eigenvalue)) state.nearest_eigenvalue = value;
    if (value < 0) ++state.negative_eigenvalues;
  }
}

BranchPoint Branch::pressure_axis() const {
  BranchPoint axis{};
  axis[n_] = 1;
  return axis;
}

/// How far the coordinates of two points are apart.
double Branch::movement(const BranchPoint& a, const BranchPoint& b) const {
  return distance(at_pressure(0, a), at_pressure(0, b));
}

BranchPoint Branch::ahead(double length) const {
  BranchPoint x = here_.x;
  for (int i = 0; i <= n_; ++i) x[i] += length * here_.tangent[i];
  return x;
}

/// The equilibrium in the plane through `start` with the given normal, found from `start`.
std::optional<BranchState> Branch::corrected(const BranchPoint& start, const BranchPoint& normal) {
  BranchState state;
  const auto system = [&](std::span<const double> x, std::span<double> residual,
                          std::span<double> jacobian) {
    const auto at = balance_.at(x);
    if (!at) return false;
    state.balance = *at;
    fill_bordered(jacobian, *at, normal, n_);
    std::copy_n(at->residual.begin(), n_, residual.begin());
    residual[n_] = 0;
    for (int i = 0; i <= n_; ++i) residual[n_] += normal[i] * (x[i] - start[i]);
    return true;
  };
  state.x = start;
  const bool solved =
      newton_.solve(std::span<double>(state.x).first(n_ + 1), system, most_iterations);
  iterations_ += newton_.iterations();
  if (!solved) return std::nullopt;
  examine_stability(state);
  state.tangent = tangent_at(state.balance, here_.tangent, n_);
  return state;
}

Branch::Step Branch::try_step(const BranchPoint& start, const BranchPoint& normal) {
  const auto state = corrected(start, normal);
  if (!state) return {};
  // In coordinates alone: a pressure far beyond the liner's strength would hide their changes.
  const double contraction =
      movement(state->x, start) / std::max(movement(state->x, here_.x), 1e-6);
  const bool accepted = contraction <= greatest_contraction &&
                        dot(state->tangent, here_.tangent) >= least_alignment &&
                        !may_turn_between(here_, *state, n_);
  return {*state, contraction, accepted};
}

Reached Branch::advance_to(double pressure_mpa) {
  const double target = balance_.scaled_pressure(pressure_mpa);
  if (target == here_.x[n_]) return Reached::target;
  const double sign = target > here_.x[n_] ? 1 : -1;
  // Only at rest can the tangent still point the other way.
  if (here_.tangent[n_] * sign < 0) {
    for (double& t : here_.tangent) t = -t;
  }
  if (at_end(target, sign)) return Reached::end;
  while (true) {
    const Reached reached = follow_to(target, sign);
    // Close to a rubber's stretch limit a coarse quadrature loses its solution before a fine one
    // does.
    const bool final = reached != Reached::lost || at_law_end() || has_grown_away();
    if (final || !refine_here()) return reached;
    step_length_ = first_step;
  }
}

Reached Branch::follow_to(double target, double sign) {
  const auto beyond_target = [&](double pressure) { return (pressure - target) * sign > 0; };
  for (int count = 0; count < options_.most_steps && step_length_ > smallest_step; ++count) {
    if (at_law_end()) return Reached::lost;
    step_length_ = within_laws(step_length_);
    const double to_target = (target - here_.x[n_]) / here_.tangent[n_];
    const bool landing = to_target <= step_length_;
    const double length = landing ? to_target : step_length_;
    const Step step = landing ? try_step(at_pressure(target, ahead(length)), pressure_axis())
                              : try_step(ahead(length), here_.tangent);
    const double change = wanted_contraction / std::max(step.contraction, 1e-3);
    if (!step.accepted || (!landing && beyond_target(step.state.x[n_]))) {
      step_length_ = length * std::clamp(change, 0.1, 0.5);
      continue;
    }
    if (step.state.tangent[n_] * sign <= 0) {
      // So far out the slope of the pressure is below rounding.
      if (largest_growth() > 0.1 * endless_growth) return end_of_growth();
      const auto limit = limit_point_before(step.state);
      if (limit && !beyond_target(limit->x[n_])) return end_at(*limit);
      if (limit && land_before(*limit, target)) return finish_landing();
      step_length_ = 0.5 * length;
      continue;
    }
    // A crossing that cannot be pinned down between here and there is a step to another branch.
    if (step.state.negative_eigenvalues != here_.negative_eigenvalues &&
        !note_bifurcation_before(step.state)) {
      step_length_ = 0.5 * length;
      continue;
    }
    if (step.state.x[n_ - 1] < closed_bore) return note_closure(step.state);
    note_angle_extrema_before(step.state);
    here_ = step.state;
    if (at_law_end()) return Reached::lost;
    const double next = length * std::clamp(change, 0.5, 4.0);
    step_length_ = std::min(landing ? std::max(step_length_, next) : next, longest_step());
    if (landing) return finish_landing();
    // The path must be the section's own, not a coarse quadrature's.
    refine_to(path_accuracy);
    if (largest_growth() > endless_growth) return end_of_growth();
  }
  return Reached::lost;
}

Reached Branch::end_at(const CriticalState& end) {
  critical_points_.push_back(end);
  return Reached::end;
}

BranchPoint Branch::at_pressure(double pressure, BranchPoint x) const {
  x[n_] = pressure;
  return x;
}

/// Whether the branch is known to end before `target`.
bool Branch::at_end(double target, double sign) const {
  if (critical_points_.empty()) return false;
  const CriticalState& last = critical_points_.back();
  return last.kind != CriticalKind::bifurcation && (last.x[n_] - target) * sign <= 0;
}

/// Whether a horseshoe or the liner's rubber is where its law ends. A Gent rubber comes ever closer
/// to its limit as the pressure rises, a path that costs more and more and says nothing more.
bool Branch::at_law_end() const {
  if (stretch_limit_used(balance_.section(), balance_.deformation(here_.x)) > 1 - law_end) {
    return true;
  }
  const auto room = room_in_laws(balance_, here_.x);
  return room && *room < law_end;
}

/// A step that would take a horseshoe past its law's end is shortened to nine tenths of the way
/// there: a few such steps come to the end, where halving would take dozens.
double Branch::within_laws(double length) const {
  const auto here = room_in_laws(balance_, here_.x);
  if (!here) return length;
  const auto there = room_in_laws(balance_, ahead(length));
  return there && *there < 0 ? length * 0.9 * *here / (*here - *there) : length;
}

double Branch::largest_growth() const {
  double growth = 0;
  for (int i = 0; i < n_; ++i) growth = std::max(growth, std::abs(here_.x[i]));
  return growth;
}

/// A branch may turn within a share of what it has come, however straight it seems: another one
/// runs beside it where stiff strands snap.
double Branch::longest_step() const {
  return 0.25 * std::max(2.0, 1 + std::max(largest_growth(), std::abs(here_.x[n_])));
}

bool Branch::has_grown_away() const {
  return largest_growth() > 0.1 * endless_growth;
}

/// Where the pressure still rises noticeably, it has no bound that could be named.
Reached Branch::end_of_growth() {
  const CriticalState asymptote = asymptote_here();
  return asymptote.pressure_error < near_its_bound ? end_at(asymptote) : Reached::lost;
}

/// A soft tube can widen without end while the pressure tends to a bound (a neo-Hookean tube of
/// held length does); there is no limit point to find then.
CriticalState Branch::asymptote_here() const {
  const double left = std::abs(here_.tangent[n_]) * largest_growth();
  return {CriticalKind::asymptote, here_.x, here_.balance, left / std::abs(here_.x[n_])};
}

/// Moves here to a pressure short of a known limit point. Near it the state goes with the square
/// root of the pressure that is left, which predicts far better than the tangent.
bool Branch::land_before(const CriticalState& limit, double target) {
  const double left = (limit.x[n_] - target) / (limit.x[n_] - here_.x[n_]);
  const BranchPoint start = at_pressure(target, between(limit.x, here_.x, std::sqrt(left)));
  const auto state = corrected(start, pressure_axis());
  if (!state || state->negative_eigenvalues != here_.negative_eigenvalues ||
      movement(state->x, start) > greatest_contraction * movement(state->x, here_.x)) {
    return false;
  }
  here_ = *state;
  return true;
}

/// The limit point between here and an equilibrium past it. The eigenvalue is nearly linear in arc
/// length there, which gives the guess.
std::optional<CriticalState> Branch::limit_point_before(const BranchState& beyond) {
  if (!limit_newton_) limit_newton_.emplace(limit_point_unknowns(balance_));
  const double before = std::abs(here_.nearest_solved_eigenvalue);
  const double fraction = before / (before + std::abs(beyond.nearest_solved_eigenvalue));
  BranchPoint guess = between(here_.x, beyond.x, fraction);
  const double step = distance(here_.x, beyond.x);
  while (true) {
    const auto found = locate_limit_point(balance_, *limit_newton_, guess);
    iterations_ += limit_newton_->iterations();
    // Between means between: anything else belongs to another branch.
    if (!found || distance(found->x, here_.x) > 1.1 * step ||
        distance(found->x, beyond.x) > 1.1 * step) {
      return std::nullopt;
    }
    if (found->pressure_error <= options_.error_goal || !balance_.refine(found->x)) {
      return is_connected(found->x) ? found : std::nullopt;
    }
    guess = found->x;
  }
}

/// Whether the branch runs along the chord from here to a limit point, pressure rising, stability
/// as here. Where stiff strands lock, it may leave the chord for much higher pressures, and what
/// lies behind is where another branch has its least pressure.
bool Branch::is_connected(const BranchPoint& limit) {
  const double length = distance(limit, here_.x);
  BranchPoint chord{};
  for (int i = 0; i <= n_; ++i) chord[i] = (limit[i] - here_.x[i]) / length;
  for (int i = 1; i < limit_checks; ++i) {
    const BranchPoint start = between(here_.x, limit, static_cast<double>(i) / limit_checks);
    const auto state = corrected(start, chord);
    if (!state || state->negative_eigenvalues != here_.negative_eigenvalues ||
        distance(state->x, start) > greatest_contraction * length ||
        std::abs(state->x[n_]) > std::abs(limit[n_])) {
      return false;
    }
  }
  return true;
}

/// The pressure at which an eigenvalue changes sign without the branch turning back, by the secant
/// method kept inside its bracket (Illinois).
std::optional<CriticalState> Branch::bifurcation_before(const BranchState& beyond) {
  BranchPoint low = here_.x;
  BranchPoint high = beyond.x;
  double at_low = std::abs(here_.nearest_eigenvalue);
  double at_high = -std::abs(beyond.nearest_eigenvalue);
  const double slope = (at_low - at_high) / (low[n_] - high[n_]);
  int side = 0;
  for (int i = 0; i < 60; ++i) {
    const BranchPoint start = between(low, high, at_low / (at_low - at_high));
    const auto middle = corrected(start, pressure_axis());
    if (!middle ||
        distance(middle->x, start) > greatest_contraction * distance(here_.x, beyond.x)) {
      return std::nullopt;
    }
    const double error = std::abs(middle->nearest_eigenvalue / (slope * middle->x[n_]));
    if (error < bifurcation_accuracy) {
      return CriticalState{CriticalKind::bifurcation, middle->x, middle->balance, error};
    }
    const bool before = middle->negative_eigenvalues == here_.negative_eigenvalues;
    (before ? low : high) = middle->x;
    (before ? at_low : at_high) = std::abs(middle->nearest_eigenvalue) * (before ? 1 : -1);
    const int now = before ? 1 : -1;
    if (now == side) (before ? at_high : at_low) *= 0.5;
    side = now;
  }
  return std::nullopt;
}

/// A path good to `path_accuracy` is not enough here: the quadrature is refined until the extrema
/// are good.
void Branch::note_angle_extrema_before(const BranchState& beyond) {
  const auto equilibrium = [&](const BranchPoint& start) {
    return corrected(start, pressure_axis());
  };
  while (true) {
    std::vector<ExtremumState> found = angle_extrema_between(balance_, here_, beyond, equilibrium);
    double worst = 0;
    for (ExtremumState& extremum : found) {
      const double error = error_at(extremum.x, extremum.balance);
      extremum.pressure_error = std::max(extremum.pressure_error, error);
      worst = std::max(worst, error);
    }
    if (worst > extremum_goal && balance_.refine(beyond.x)) continue;
    angle_extrema_.insert(angle_extrema_.end(), found.begin(), found.end());
    return;
  }
}

/// The branch ends where the bore is down to a thousandth; the energy does not know of contact.
/// Lands on that bore between here and a state past it.
Reached Branch::note_closure(const BranchState& beyond) {
  BranchPoint normal{};
  normal[n_ - 1] = 1;
  const double fraction = (closed_bore - here_.x[n_ - 1]) / (beyond.x[n_ - 1] - here_.x[n_ - 1]);
  BranchPoint start = between(here_.x, beyond.x, fraction);
  start[n_ - 1] = closed_bore;
  while (true) {
    const auto closed = corrected(start, normal);
    if (!closed) return Reached::lost;
    const auto finer = balance_.finer_at(closed->x);
    if (!finer) return Reached::lost;
    BranchPoint error{};
    std::copy_n(finer->residual.begin(), n_, error.begin());
    solve_bordered(closed->balance, normal, error, n_);
    const double relative = std::abs(error[n_] / closed->x[n_]);
    if (relative <= options_.error_goal || !balance_.refine(closed->x)) {
      return end_at({CriticalKind::closure, closed->x, closed->balance, relative});
    }
    start = closed->x;
  }
}

bool Branch::note_bifurcation_before(const BranchState& beyond) {
  const auto bifurcation = bifurcation_before(beyond);
  if (bifurcation) critical_points_.push_back(*bifurcation);
  return bifurcation.has_value();
}

/// Takes a finer quadrature and moves here to its equilibrium at the same pressure.
bool Branch::refine_here() {
  if (!balance_.refine(here_.x)) return false;
  const auto refined = corrected(here_.x, pressure_axis());
  if (refined) here_ = *refined;
  return refined.has_value();
}

/// Largest error of a scaled coordinate: twice the finer quadrature's residual, since that one is
/// not exact either, and what else is in doubt, mapped by H^-1; and the rounding of the coordinate
/// itself.
double Branch::error_at(const BranchPoint& x, const BalanceAt& balance) const {
  const auto finer = balance_.finer_at(x);
  if (!finer) return std::numeric_limits<double>::infinity();
  const BalanceAt::Vector doubt = balance_.doubt(x, balance);
  BalanceAt::Matrix stiffness = balance.tangent_stiffness;
  BalanceAt::Matrix inverse;
  invert(std::span(stiffness).first(n_ * n_), std::span(inverse).first(n_ * n_));
  double error = 0;
  for (int i = 0; i < n_; ++i) {
    double moved = 0;
    double doubted = 0;
    for (int j = 0; j < n_; ++j) {
      moved += inverse[j * n_ + i] * finer->residual[j];
      doubted += std::abs(inverse[j * n_ + i]) * doubt[j];
    }
    error = std::max(error, 2 * std::abs(moved) + doubted);
  }
  double largest = 1;
  for (int i = 0; i < n_; ++i) largest = std::max(largest, 1 + std::abs(x[i]));
  return error + largest * std::numeric_limits<double>::epsilon();
}

/// Refines the quadrature until the state here is good to `goal`, or rounding lets it get no
/// better.
void Branch::refine_to(double goal) {
  here_.error_estimate = error_at(here_.x, here_.balance);
  double before = std::numeric_limits<double>::infinity();
  while (here_.error_estimate > goal && here_.error_estimate < 0.9 * before) {
    before = here_.error_estimate;
    if (!refine_here()) break;
    here_.error_estimate = error_at(here_.x, here_.balance);
  }
}

Reached Branch::finish_landing() {
  refine_to(options_.error_goal);
  return Reached::target;
}

}  // namespace latticast
