// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/limit_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr int most_limit_point_iterations = 25;
constexpr double difference_step = 1e-5;

/// Eigenvector of the eigenvalue nearest to zero.
BalanceAt::Vector nearly_free_direction(const BalanceAt& balance, int n) {
  BalanceAt::Matrix stiffness = balance.tangent_stiffness;
  BalanceAt::Vector values{};
  BalanceAt::Matrix vectors{};
  symmetric_eigenvectors(std::span(stiffness).first(entry_count(n)), std::span(values).first(n),
                         std::span(vectors).first(entry_count(n)));
  int nearest = 0;
  for (int i = 1; i < n; ++i) {
    if (std::abs(values[i]) < std::abs(values[nearest])) nearest = i;
  }
  BalanceAt::Vector direction{};
  std::copy_n(&vectors[entry_at(0, nearest, n)], n, direction.begin());
  return direction;
}

/// d(H v)/dq = dH along v, the third derivatives being symmetric. Central differences are enough:
/// the solution does not depend on this Jacobian, only the speed of convergence does.
std::optional<BalanceAt::Matrix> stiffness_slope(const EquilibriumEquations& equations,
                                                 std::span<const double> x,
                                                 std::span<const double> direction) {
  const int n = equations.size;
  BranchPoint ahead{};
  BranchPoint behind{};
  std::copy_n(x.begin(), n + 1, ahead.begin());
  behind = ahead;
  for (int i = 0; i < n; ++i) {
    ahead[i] += difference_step * direction[i];
    behind[i] -= difference_step * direction[i];
  }
  const auto after = equations.at(ahead);
  const auto before = equations.at(behind);
  if (!after || !before) return std::nullopt;
  BalanceAt::Matrix slope{};
  for (int i = 0; i < n * n; ++i) {
    slope[i] = (after->tangent_stiffness[i] - before->tangent_stiffness[i]) / (2 * difference_step);
  }
  return slope;
}

/// Unknowns: n coordinates, pressure, v.
bool extended_system(const EquilibriumEquations& equations, std::span<const double> y,
                     std::span<double> residual, std::span<double> jacobian) {
  const int n = equations.size;
  const auto at = equations.at(y);
  if (!at) return false;
  const std::span<const double> v = y.subspan(n + 1, n);
  const auto slope = stiffness_slope(equations, y, v);
  if (!slope) return false;

  const int rows = 2 * n + 1;
  const auto last = 2 * static_cast<std::size_t>(n);
  const auto entry = [&](int row, int column) -> double& {
    return jacobian[entry_at(row, column, rows)];
  };
  std::fill(residual.begin(), residual.end(), 0.0);
  std::fill(jacobian.begin(), jacobian.end(), 0.0);
  residual[last] = -0.5;
  for (int j = 0; j < n; ++j) {
    residual[j] = at->residual[j];
    residual[last] += 0.5 * v[j] * v[j];
    entry(j, n) = -at->load_vector[j];
    entry(2 * n, n + 1 + j) = v[j];
    for (int i = 0; i < n; ++i) {
      const double stiffness = at->tangent_stiffness[entry_at(i, j, n)];
      residual[n + i] += stiffness * v[j];
      entry(i, j) = stiffness;
      entry(n + i, j) = (*slope)[entry_at(i, j, n)];
      entry(n + i, n) -= at->load_stiffness[j * n + i] * v[j];
      entry(n + i, n + 1 + j) = stiffness;
    }
  }
  return true;
}

}  // namespace

std::optional<CriticalState> locate_limit_point(const EquilibriumEquations& equations,
                                                NewtonSolver& newton, const BranchPoint& guess) {
  const int n = equations.size;
  const auto near = equations.at(guess);
  if (!near) return std::nullopt;
  std::vector<double> y(guess.begin(), guess.begin() + n + 1);
  const BalanceAt::Vector start = nearly_free_direction(*near, n);
  y.insert(y.end(), start.begin(), start.begin() + n);

  const auto system = [&](std::span<const double> at, std::span<double> residual,
                          std::span<double> jacobian) {
    return extended_system(equations, at, residual, jacobian);
  };
  if (!newton.solve(y, system, most_limit_point_iterations)) return std::nullopt;

  CriticalState found;
  std::copy_n(y.begin(), n + 1, found.x.begin());
  const auto at = equations.at(found.x);
  const auto finer = equations.finer_at(found.x);
  if (!at || !finer) return std::nullopt;
  found.balance = *at;
  found.iterations = newton.iterations();
  // Along v the stiffness is zero, so a residual in that direction is made good by pressure.
  double residual = 0;
  double load = 0;
  for (int i = 0; i < n; ++i) {
    residual += y[n + 1 + i] * finer->residual[i];
    load += y[n + 1 + i] * at->load_vector[i];
  }
  found.pressure_error = std::abs(residual / (load * found.x[n]));
  return found;
}

}  // namespace latticast
