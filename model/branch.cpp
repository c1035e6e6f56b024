// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/branch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace latticast {
namespace {

// No heap: a section has at most three free coordinates and the pressure.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 4>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4, 1>;
using Eigen::Map;

constexpr int most_iterations = 12;
constexpr double first_reach = 1.0;
constexpr double smallest_reach = 1e-10;
constexpr double endless_growth = 1e4;    // of a scaled coordinate, whose order is 1
constexpr double wanted_turning = 0.08;   // correction against step that a step is chosen for ...
constexpr double greatest_turning = 0.2;  // ... and beyond which it does not count
constexpr double least_alignment = 0.5;   // cosine between successive tangents

double dot(const BranchPoint& a, const BranchPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

double distance(const BranchPoint& a, const BranchPoint& b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), std::hypot(a[2] - b[2], a[3] - b[3]));
}

BranchPoint between(const BranchPoint& a, const BranchPoint& b, double fraction) {
  BranchPoint x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = a[i] + fraction * (b[i] - a[i]);
  return x;
}

void examine_stability(BranchState& state, int n) {
  const Map<const Eigen::MatrixXd> stiffness(state.balance.stiffness.data(), n, n);
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(stiffness, Eigen::EigenvaluesOnly);
  const auto& values = eigen.eigenvalues();
  Eigen::Index nearest = 0;
  values.cwiseAbs().minCoeff(&nearest);
  state.smallest_eigenvalue = values[0];
  state.nearest_eigenvalue = values[nearest];
  state.negative_eigenvalues = static_cast<int>((values.array() < 0).count());
}

/// The direction in which imbalance stays zero, on the side of `guide`. Bordering with `guide` keeps
/// the system regular where the stiffness alone is singular.
BranchPoint tangent_at(const BalanceAt& balance, const BranchPoint& guide, int n) {
  Matrix bordered(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = Map<const Eigen::MatrixXd>(balance.stiffness.data(), n, n);
  bordered.topRightCorner(n, 1) = -Map<const Eigen::VectorXd>(balance.push.data(), n);
  bordered.bottomRows(1) = Map<const Eigen::RowVectorXd>(guide.data(), n + 1);
  Vector right = Vector::Zero(n + 1);
  right[n] = 1;
  const Vector direction = bordered.partialPivLu().solve(right).normalized();
  BranchPoint tangent{};
  std::copy(direction.begin(), direction.end(), tangent.begin());
  return tangent;
}

}  // namespace

Branch::Branch(const Section& section, Held held, const SolverOptions& options)
    : balance_(section, held, options.fixed_quadrature),
      options_(options),
      n_(balance_.free_count()),
      newton_(n_ + 1) {
  restart();
}

void Branch::restart() {
  here_ = {};
  here_.balance = *balance_.at(here_.x);
  examine_stability(here_, n_);
  here_.tangent = tangent_at(here_.balance, pressure_axis(), n_);
  reach_ = first_reach;
  critical_points_.clear();
}

BranchPoint Branch::pressure_axis() const {
  BranchPoint axis{};
  axis[n_] = 1;
  return axis;
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
    const Eigen::Index size = n_ + 1;
    Map<Eigen::MatrixXd> j(jacobian.data(), size, size);
    j.topLeftCorner(n_, n_) = Map<const Eigen::MatrixXd>(at->stiffness.data(), n_, n_);
    residual[n_] = 0;
    for (int i = 0; i < n_; ++i) {
      residual[i] = at->imbalance[i];
      j(i, n_) = -at->push[i];
    }
    for (int i = 0; i <= n_; ++i) {
      residual[n_] += normal[i] * (x[i] - start[i]);
      j(n_, i) = normal[i];
    }
    return true;
  };
  state.x = start;
  const bool solved =
      newton_.solve(std::span<double>(state.x).first(n_ + 1), system, most_iterations);
  iterations_ += newton_.iterations();
  if (!solved) return std::nullopt;
  examine_stability(state, n_);
  state.tangent = tangent_at(state.balance, here_.tangent, n_);
  return state;
}

Branch::Step Branch::try_step(const BranchPoint& start, const BranchPoint& normal) {
  const auto state = corrected(start, normal);
  if (!state) return {};
  const double turning = distance(state->x, start) / distance(state->x, here_.x);
  const bool accepted =
      turning <= greatest_turning && dot(state->tangent, here_.tangent) >= least_alignment;
  return {*state, turning, accepted};
}

Reached Branch::advance_to(double pressure_mpa) {
  const double target = balance_.scaled_pressure(pressure_mpa);
  if (target == here_.x[n_]) return Reached::target;
  const double sign = target > here_.x[n_] ? 1 : -1;
  // Only at rest can the tangent still point the other way.
  if (here_.tangent[n_] * sign < 0) {
    for (double& t : here_.tangent) t = -t;
  }
  const auto beyond_target = [&](double pressure) { return (pressure - target) * sign > 0; };
  if (at_end(target, sign)) return Reached::end;

  for (int count = 0; count < options_.most_steps && reach_ > smallest_reach; ++count) {
    const double to_target = (target - here_.x[n_]) / here_.tangent[n_];
    const bool landing = to_target <= reach_;
    const double length = landing ? to_target : reach_;
    BranchPoint start = ahead(length);
    if (landing) start[n_] = target;
    const Step step = try_step(start, landing ? pressure_axis() : here_.tangent);
    if (!step.accepted || (!landing && beyond_target(step.state.x[n_]))) {
      reach_ = length * std::clamp(wanted_turning / std::max(step.turning, 1e-3), 0.1, 0.5);
      continue;
    }
    const bool turned_back = step.state.tangent[n_] * sign <= 0;
    const bool crossed = step.state.negative_eigenvalues != here_.negative_eigenvalues;
    if (turned_back) {
      const auto limit = limit_point_before(step.state);
      if (limit && !beyond_target(limit->x[n_])) {
        critical_points_.push_back(*limit);
        return Reached::end;
      }
      if (limit && land_before(*limit, target)) return Reached::target;
      reach_ = 0.5 * length;
      continue;
    }
    if (crossed) {
      if (const auto bifurcation = bifurcation_before(step.state)) {
        critical_points_.push_back(*bifurcation);
      }
    }
    here_ = step.state;
    const double next = length * std::clamp(wanted_turning / std::max(step.turning, 1e-3), 0.5, 4.0);
    reach_ = landing ? std::max(reach_, next) : next;
    if (landing) {
      finish_landing();
      return Reached::target;
    }
    if (grown_without_end()) return Reached::end;
  }
  return Reached::lost;
}

/// Whether the branch is known to end before `target`.
bool Branch::at_end(double target, double sign) const {
  if (critical_points_.empty()) return false;
  const CriticalPoint& last = critical_points_.back();
  return last.kind != LimitKind::bifurcation && (last.x[n_] - target) * sign <= 0;
}

/// A soft tube can widen without end while the pressure tends to a bound (a neo-Hookean tube of held
/// length does); there is no limit point to find then.
bool Branch::grown_without_end() {
  double growth = 0;
  for (int i = 0; i < n_; ++i) growth = std::max(growth, std::abs(here_.x[i]));
  if (growth < endless_growth) return false;
  CriticalPoint end;
  end.kind = LimitKind::asymptote;
  end.x = here_.x;
  end.balance = here_.balance;
  end.pressure_error = std::abs(here_.tangent[n_] * growth / here_.x[n_]);
  critical_points_.push_back(end);
  return true;
}

/// Lands on a pressure short of a known limit point. Near it the state goes with the square root of
/// the pressure that is left, which predicts far better than the tangent.
bool Branch::land_before(const CriticalPoint& limit, double target) {
  const double left = (limit.x[n_] - target) / (limit.x[n_] - here_.x[n_]);
  BranchPoint start = between(limit.x, here_.x, std::sqrt(left));
  start[n_] = target;
  const Step step = try_step(start, pressure_axis());
  if (!step.accepted || step.state.negative_eigenvalues != here_.negative_eigenvalues) return false;
  here_ = step.state;
  finish_landing();
  return true;
}

/// The limit point between here and an equilibrium past it. The eigenvalue is nearly linear in arc
/// length there, which gives the guess.
std::optional<CriticalPoint> Branch::limit_point_before(const BranchState& beyond) {
  if (!limit_newton_) limit_newton_.emplace(limit_point_unknowns(balance_));
  const double before = std::abs(here_.nearest_eigenvalue);
  const double fraction = before / (before + std::abs(beyond.nearest_eigenvalue));
  auto found = locate_limit_point(balance_, *limit_newton_, between(here_.x, beyond.x, fraction));
  for (int i = 0; i < 2; ++i) {
    iterations_ += limit_newton_->iterations();
    // Between means between: anything else belongs to another branch.
    const double step = distance(here_.x, beyond.x);
    if (!found || distance(found->x, here_.x) > 1.1 * step ||
        distance(found->x, beyond.x) > 1.1 * step) {
      return std::nullopt;
    }
    if (found->pressure_error <= options_.error_goal || !balance_.refine()) break;
    found = locate_limit_point(balance_, *limit_newton_, found->x);
  }
  return found;
}

/// The pressure at which an eigenvalue changes sign without the branch turning back, by the secant
/// method kept inside its bracket (Illinois).
std::optional<CriticalPoint> Branch::bifurcation_before(const BranchState& beyond) {
  BranchPoint low = here_.x;
  BranchPoint high = beyond.x;
  double at_low = std::abs(here_.nearest_eigenvalue);
  double at_high = -std::abs(beyond.nearest_eigenvalue);
  CriticalPoint found;
  found.kind = LimitKind::bifurcation;
  int side = 0;
  for (int i = 0; i < 60; ++i) {
    const auto middle = corrected(between(low, high, at_low / (at_low - at_high)), pressure_axis());
    if (!middle) return std::nullopt;
    found.x = middle->x;
    found.balance = middle->balance;
    const bool before = middle->negative_eigenvalues == here_.negative_eigenvalues;
    (before ? low : high) = middle->x;
    (before ? at_low : at_high) = std::abs(middle->nearest_eigenvalue) * (before ? 1 : -1);
    const int now = before ? 1 : -1;
    if (now == side) (before ? at_high : at_low) *= 0.5;
    side = now;
    found.pressure_error = std::abs((high[n_] - low[n_]) / middle->x[n_]);
    if (found.pressure_error < 1e-12 || std::abs(middle->nearest_eigenvalue) < 1e-13) break;
  }
  return found;
}

/// Refines the quadrature until the state is as good as asked for, and records how good it is.
void Branch::finish_landing() {
  const auto estimate = [&] {
    const auto finer = balance_.finer_at(here_.x);
    if (!finer) return std::numeric_limits<double>::infinity();
    const Map<const Eigen::MatrixXd> stiffness(here_.balance.stiffness.data(), n_, n_);
    const Map<const Eigen::VectorXd> imbalance(finer->imbalance.data(), n_);
    const Vector error = Matrix(stiffness).partialPivLu().solve(Vector(imbalance));
    return error.cwiseAbs().maxCoeff();
  };
  here_.error_estimate = estimate();
  while (here_.error_estimate > options_.error_goal && balance_.refine()) {
    const auto refined = corrected(here_.x, pressure_axis());
    if (!refined) return;
    const double before = here_.error_estimate;
    here_ = *refined;
    here_.error_estimate = estimate();
    if (here_.error_estimate > 0.5 * before) return;
  }
}

}  // namespace latticast
