// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "bench/arc_continuation.h"
#include "bench/arc_method.h"

namespace latticast {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Values at Chebyshev points of [0, length] from values there: integrals from the start, and the
// whole integral.
struct Integration {
  MatrixXd from_start;
  Eigen::RowVectorXd whole;
};

double chebyshev(int degree, double x) {
  return std::cos(degree * std::acos(x));
}

// The integral of T_k from -1.
double chebyshev_integral(int k, double x) {
  if (k == 0) return x + 1;
  if (k == 1) return (x * x - 1) / 2;
  const double sign = k % 2 == 0 ? 1 : -1;
  return chebyshev(k + 1, x) / (2.0 * (k + 1)) - chebyshev(k - 1, x) / (2.0 * (k - 1)) -
         sign / (static_cast<double>(k) * k - 1);
}

Integration integration(int order, double length) {
  const int n = order + 1;
  MatrixXd values(n, n);
  MatrixXd integrals(n, n);
  for (int i = 0; i < n; ++i) {
    const double x = -std::cos(std::numbers::pi * i / order);
    for (int k = 0; k < n; ++k) {
      values(i, k) = chebyshev(k, x);
      integrals(i, k) = chebyshev_integral(k, x) * length / 2;
    }
  }
  const MatrixXd from_start = values.transpose().partialPivLu().solve(integrals.transpose());
  return {from_start.transpose(), from_start.col(order).transpose()};
}

// Unknowns: theta'' at the points, then beta.
class Collocation {
 public:
  Collocation(const Arc& arc, int order)
      : arc_(arc), n_(order + 1), along_(integration(order, arc.half_angle_rad)) {
    // theta' = 1 - integral to the end; theta = its integral from the start.
    slope_by_ = along_.from_start.rowwise() - along_.whole;
    theta_by_ = along_.from_start * slope_by_;
    circle_ = along_.from_start * VectorXd::Ones(n_);
  }

  std::optional<VectorXd> solve(double strain, VectorXd unknowns) const {
    MatrixXd jacobian(n_ + 1, n_ + 1);
    VectorXd residual(n_ + 1);
    for (int iteration = 0; iteration < 12; ++iteration) {
      evaluate(strain, unknowns, residual, jacobian);
      const VectorXd step = jacobian.partialPivLu().solve(residual);
      unknowns -= step;
      if (!unknowns.allFinite()) return std::nullopt;
      if (step.norm() <= 1e-9 * (1 + unknowns.norm())) return unknowns;
    }
    return std::nullopt;
  }

  int unknown_count() const { return n_ + 1; }

 private:
  void evaluate(double strain, const VectorXd& unknowns, VectorXd& residual,
                MatrixXd& jacobian) const {
    const double beta = unknowns[n_];
    const double delta = arc_.compliance * beta;
    const double sine = std::sin(arc_.half_angle_rad);
    const Eigen::ArrayXd theta = circle_ + theta_by_ * unknowns.head(n_);
    const Eigen::ArrayXd s = theta.sin();
    const Eigen::ArrayXd c = theta.cos();
    residual.head(n_) = unknowns.head(n_).array() - beta * s * (1 + delta * c);
    residual[n_] = along_.whole.dot((c * (1 + delta * c)).matrix()) / sine - 1 - strain;
    const VectorXd turning = beta * (c + delta * (c * c - s * s));
    jacobian.topLeftCorner(n_, n_) = MatrixXd::Identity(n_, n_) - turning.asDiagonal() * theta_by_;
    jacobian.col(n_).head(n_) = -s * (1 + 2 * delta * c);
    const VectorXd shortening = -s * (1 + 2 * delta * c);
    jacobian.row(n_).head(n_) = (along_.whole * shortening.asDiagonal()) * theta_by_ / sine;
    jacobian(n_, n_) = arc_.compliance * along_.whole.dot((c * c).matrix()) / sine;
  }

  Arc arc_;
  int n_;
  Integration along_;
  MatrixXd slope_by_;
  MatrixXd theta_by_;
  VectorXd circle_;  // theta of the arc at rest
};

}  // namespace

std::optional<double> collocated_force(const Arc& arc, double strain, int order) {
  const Collocation collocation(arc, order);
  const auto solve = [&](double at, const VectorXd& guess) { return collocation.solve(at, guess); };
  const auto found = followed(solve, VectorXd::Zero(collocation.unknown_count()), strain);
  if (!found) return std::nullopt;
  return (*found)[found->size() - 1];
}

}  // namespace latticast
