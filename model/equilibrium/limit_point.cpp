// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/limit_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace latticast {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_iterations = 25;
constexpr double difference_step = 1e-5;

/// Eigenvector of the eigenvalue nearest to zero.
VectorXd nearly_free_direction(const BalanceAt& balance, int n) {
  const Map<const MatrixXd> stiffness(balance.stiffness.data(), n, n);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(stiffness);
  Eigen::Index nearest = 0;
  eigen.eigenvalues().cwiseAbs().minCoeff(&nearest);
  return eigen.eigenvectors().col(nearest);
}

/// d(H v)/dq = dH along v, the third derivatives being symmetric. Central differences are enough:
/// the solution does not depend on this Jacobian, only the speed of convergence does.
std::optional<MatrixXd> stiffness_slope(const Balance& balance, std::span<const double> x,
                                        const VectorXd& direction) {
  const int n = balance.free_count();
  BranchPoint ahead{};
  BranchPoint behind{};
  std::copy_n(x.begin(), n + 1, ahead.begin());
  behind = ahead;
  for (int i = 0; i < n; ++i) {
    ahead[i] += difference_step * direction[i];
    behind[i] -= difference_step * direction[i];
  }
  const auto after = balance.at(ahead);
  const auto before = balance.at(behind);
  if (!after || !before) return std::nullopt;
  return (Map<const MatrixXd>(after->stiffness.data(), n, n) -
          Map<const MatrixXd>(before->stiffness.data(), n, n)) /
         (2 * difference_step);
}

/// Unknowns: n coordinates, pressure, v.
bool extended_system(const Balance& balance, std::span<const double> y, std::span<double> residual,
                     std::span<double> jacobian) {
  const Eigen::Index n = balance.free_count();
  const auto at = balance.at(y);
  if (!at) return false;
  const Map<const VectorXd> v(y.data() + n + 1, n);
  const auto slope = stiffness_slope(balance, y, v);
  if (!slope) return false;
  const Map<const MatrixXd> stiffness(at->stiffness.data(), n, n);
  const Map<const VectorXd> imbalance(at->imbalance.data(), n);
  const Map<const VectorXd> push(at->push.data(), n);
  const Map<const MatrixXd> push_slope(at->push_slope.data(), n, n);

  Map<VectorXd> f(residual.data(), 2 * n + 1);
  f.head(n) = imbalance;
  f.segment(n, n) = stiffness * v;
  f[2 * n] = 0.5 * (v.squaredNorm() - 1);

  Map<MatrixXd> j(jacobian.data(), 2 * n + 1, 2 * n + 1);
  j.setZero();
  j.topLeftCorner(n, n) = stiffness;
  j.block(0, n, n, 1) = -push;
  j.block(n, 0, n, n) = *slope;
  j.block(n, n, n, 1) = -(push_slope * v);
  j.block(n, n + 1, n, n) = stiffness;
  j.block(2 * n, n + 1, 1, n) = v.transpose();
  return true;
}

}  // namespace

std::optional<CriticalPoint> locate_limit_point(const Balance& balance, NewtonSolver& newton,
                                                const BranchPoint& guess) {
  const int n = balance.free_count();
  const auto near = balance.at(guess);
  if (!near) return std::nullopt;
  std::vector<double> y(guess.begin(), guess.begin() + n + 1);
  const VectorXd start = nearly_free_direction(*near, n);
  y.insert(y.end(), start.begin(), start.end());

  const auto system = [&](std::span<const double> at, std::span<double> residual,
                          std::span<double> jacobian) {
    return extended_system(balance, at, residual, jacobian);
  };
  if (!newton.solve(y, system, most_iterations)) return std::nullopt;

  CriticalPoint found;
  std::copy_n(y.begin(), n + 1, found.x.begin());
  const auto at = balance.at(found.x);
  const auto finer = balance.finer_at(found.x);
  if (!at || !finer) return std::nullopt;
  found.balance = *at;
  found.iterations = newton.iterations();
  // Along v the balance does not react, so an imbalance in that direction is made good by pressure.
  const Map<const VectorXd> v(y.data() + n + 1, n);
  const double imbalance = v.dot(Map<const VectorXd>(finer->imbalance.data(), n));
  const double push = v.dot(Map<const VectorXd>(at->push.data(), n));
  found.pressure_error = std::abs(imbalance / (push * found.x[n]));
  return found;
}

}  // namespace latticast
