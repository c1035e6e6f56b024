// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <memory>

#include <Eigen/Dense>

#include "bench/arc_continuation.h"
#include "bench/arc_method.h"
#include "bench/cvode_path.h"

namespace latticast {
namespace {

// theta, theta', the chord so far, then the three's derivatives by the starting value and by beta.
constexpr int state_size = 9;
using PathState = std::array<double, state_size>;

class Shooting {
 public:
  Shooting(const Arc& arc, double tolerance, ShootingStart start)
      : arc_(arc), start_(start), path_(state_size, tolerance, tolerance / 100) {}

  std::optional<Eigen::VectorXd> solve(double strain, Eigen::VectorXd unknowns) {
    for (int iteration = 0; iteration < 12; ++iteration) {
      const auto end = shoot(unknowns[0], unknowns[1]);
      if (!end) return std::nullopt;
      const PathState& y = *end;
      const double sine = std::sin(arc_.half_angle_rad);
      Eigen::Vector2d residual;
      Eigen::Matrix2d jacobian;
      if (start_ == ShootingStart::end) {
        // Symmetry; no moment at the far end says nothing more of an arc at rest.
        residual << y[0] + unknowns[0], y[2] / (2 * sine) - 1 - strain;
        jacobian << y[3] + 1, y[6], y[5] / (2 * sine), y[8] / (2 * sine);
      } else {
        residual << y[1] - 1, y[2] / sine - 1 - strain;
        jacobian << y[4], y[7], y[5] / sine, y[8] / sine;
      }
      const Eigen::Vector2d step = jacobian.partialPivLu().solve(residual);
      unknowns -= step;
      if (!unknowns.allFinite()) return std::nullopt;
      if (step.norm() <= 1e-8 * (1e-3 + unknowns.norm())) return unknowns;
    }
    return std::nullopt;
  }

  // The circle.
  Eigen::VectorXd rest() const {
    const bool from_end = start_ == ShootingStart::end;
    return Eigen::Vector2d(from_end ? -arc_.half_angle_rad : 0, 0);
  }

 private:
  std::optional<PathState> shoot(double unknown, double beta) {
    const bool from_end = start_ == ShootingStart::end;
    PathState y{};
    y[0] = from_end ? unknown : 0;
    y[1] = from_end ? 1 : std::exp(unknown);
    y[from_end ? 3 : 4] = y[1];
    const double delta = arc_.compliance * beta;
    const auto rate = [&](double, const double* at, double* by) {
      const double s = std::sin(at[0]);
      const double c = std::cos(at[0]);
      const double turning = beta * (c + delta * (c * c - s * s));
      const double shortening = -s * (1 + 2 * delta * c);
      for (int i = 0; i < state_size; i += 3) by[i] = at[i + 1];
      by[1] = beta * s * (1 + delta * c);
      by[2] = c * (1 + delta * c);
      by[4] = turning * at[3];
      by[5] = shortening * at[3];
      by[7] = turning * at[6] + s * (1 + 2 * delta * c);
      by[8] = shortening * at[6] + arc_.compliance * c * c;
    };
    const double length = (from_end ? 2 : 1) * arc_.half_angle_rad;
    if (!path_.walk(rate, length, y)) return std::nullopt;
    return y;
  }

  Arc arc_;
  ShootingStart start_;
  CvodePath path_;
};

}  // namespace

std::optional<double> shot_force(const Arc& arc, double strain, double tolerance,
                                 ShootingStart start) {
  Shooting shooting(arc, tolerance, start);
  const auto solve = [&](double at, const Eigen::VectorXd& guess) {
    return shooting.solve(at, guess);
  };
  const auto found = followed(solve, shooting.rest(), strain);
  if (!found) return std::nullopt;
  return (*found)[1];
}

}  // namespace latticast
