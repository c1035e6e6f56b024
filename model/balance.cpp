// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/balance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace latticast {
namespace {

constexpr int most_points = 64;

/// The next rule in line: what a rule is refined to, and what its error is measured with.
int more_points(int points) {
  return points + std::max(4, points / 2);
}

/// Gauss points for about 1e-12. Everything depends on R through r/R, which has its nearest pole at
/// R = 0; the rule converges like rho^(-2n), rho belonging to the ellipse through that pole.
int points_for(double from, double to) {
  if (!(to > from)) return 1;
  const double pole = (to + from) / (to - from);
  const double rho = pole + std::sqrt(pole * pole - 1);
  const int points = static_cast<int>(std::ceil(0.5 * std::log(1e12) / std::log(rho)));
  return std::clamp(points, 3, most_points / 2);
}

}  // namespace

Balance::Balance(const Section& section, Held held, int quadrature_points) : section_(section) {
  free_.push_back(0);
  if (held.stretch) free_.clear();
  if (!held.twist) free_.push_back(1);
  free_.push_back(2);
  scale_ = {1, 1 / section.outer_radius_mm, section.inner_radius_mm};
  const double rubber_area = std::numbers::pi *
                             (section.isotropic_to_mm - section.isotropic_from_mm) *
                             (section.isotropic_to_mm + section.isotropic_from_mm);
  energy_ = section.shear_modulus_mpa * rubber_area;

  points_fixed_ = quadrature_points > 0;
  if (points_fixed_) {
    set_points(quadrature_points, quadrature_points);
  } else {
    set_points(points_for(section.isotropic_from_mm, section.isotropic_to_mm),
               points_for(section.anisotropic_from_mm, section.anisotropic_to_mm));
  }

  const int n = free_count();
  const BalanceAt rest = *at(BranchPoint{});
  const Eigen::Map<const Eigen::MatrixXd> stiffness(rest.stiffness.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> push(rest.push.data(), n);
  pressure_mpa_ = 1 / stiffness.ldlt().solve(push).norm();
}

std::optional<BalanceAt> Balance::at(std::span<const double> x) const {
  return evaluate(x, quadrature_);
}

std::optional<BalanceAt> Balance::finer_at(std::span<const double> x) const {
  return evaluate(x, finer_);
}

bool Balance::refine() {
  if (points_fixed_ || std::max(liner_points_, lattice_points_) >= most_points) return false;
  set_points(std::min(more_points(liner_points_), most_points),
             std::min(more_points(lattice_points_), most_points));
  return true;
}

void Balance::set_points(int liner, int lattice) {
  liner_points_ = liner;
  lattice_points_ = lattice;
  quadrature_ = make_quadrature(section_, liner, lattice);
  finer_ = make_quadrature(section_, more_points(liner), more_points(lattice));
}

Deformation Balance::deformation(std::span<const double> x) const {
  std::array<double, 3> q{};
  for (std::size_t i = 0; i < free_.size(); ++i) q[free_[i]] = x[i] * scale_[free_[i]];
  return {q[0], q[1], q[2]};
}

std::optional<BalanceAt> Balance::evaluate(std::span<const double> x,
                                           const Quadrature& quadrature) const {
  const Deformation q = deformation(x);
  const std::optional<SectionEnergy> stored = stored_energy(section_, quadrature, q);
  if (!stored) return std::nullopt;
  const SectionEnergy cavity = cavity_growth(section_, q);
  const double pressure = pressure_mpa(x);

  BalanceAt result;
  for (int i = 0; i < 3; ++i) {
    result.reaction[i] = stored->gradient[i] - pressure * cavity.gradient[i];
  }
  const std::size_t n = free_.size();
  for (std::size_t column = 0; column < n; ++column) {
    const int j = free_[column];
    const double scale_j = scale_[j] / energy_;
    result.imbalance[column] = result.reaction[j] * scale_j;
    result.push[column] = cavity.gradient[j] * scale_j * pressure_mpa_;
    for (std::size_t row = 0; row < n; ++row) {
      const int i = free_[row];
      const double scale = scale_[i] * scale_j;
      const double cavity_second = cavity.second(i, j);
      result.stiffness[column * n + row] =
          (stored->second(i, j) - pressure * cavity_second) * scale;
      result.push_slope[column * n + row] = cavity_second * scale * pressure_mpa_;
    }
  }
  return result;
}

}  // namespace latticast
