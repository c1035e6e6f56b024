// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/quadrature.h"

#include <algorithm>
#include <cmath>

#include "design/units.h"
#include "model/numerics/gauss.h"
#include "model/section/section_energy.h"

namespace latticast {
namespace {

constexpr double panel_ratio = 4;  // thickness of successive panels
constexpr int most_panels = 24;

std::vector<QuadraturePoint> points_between(double from, double to, int count) {
  if (!(to > from)) return {};
  const GaussRule rule = gauss_legendre(count);
  std::vector<QuadraturePoint> points(rule.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = 0.5 * ((from + to) + (to - from) * rule.points[i]);
    points[i] = {radius, pi * (to - from) * rule.weights[i] * radius};
  }
  return points;
}

std::vector<Direction> whole_turn(int count) {
  std::vector<Direction> directions(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    directions[i] = {std::cos(angle), std::sin(angle), 1.0 / count};
  }
  return directions;
}

}  // namespace

Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points, int around,
                           int bore_panels) {
  const auto points = [&](double from, double to, int count) {
    const int panels = from == section.inner_radius_mm ? bore_panels : 1;
    std::vector<QuadraturePoint> all;
    double begin = from;
    for (int i = 1; i <= panels; ++i) {
      const double end = i == panels ? to : from + (to - from) * std::pow(panel_ratio, i - panels);
      const std::vector<QuadraturePoint> panel = points_between(begin, end, count);
      all.insert(all.end(), panel.begin(), panel.end());
      begin = end;
    }
    return all;
  };
  return {points(section.isotropic_from_mm, section.isotropic_to_mm, liner_points),
          points(section.anisotropic_from_mm, section.anisotropic_to_mm, lattice_points),
          whole_turn(around)};
}

int bore_panels_for(const Section& section, const Deformation& at) {
  const double rest = section.inner_radius_mm;
  const double bore = 1 + at.inner_growth / rest;
  // Distance of the singularity from the bore, against the wall.
  double distance = 1;
  const double filled = (1 + at.elongation) * bore * bore;
  if (filled < 1) {
    // R_i - sqrt(R_i^2 - lambda a^2), without the difference of nearly equal numbers.
    distance = rest * filled / (1 + std::sqrt(1 - filled)) / (section.isotropic_to_mm - rest);
  }
  const double used = stretch_limit_used(section, at);
  if (used > 0.8) distance = std::min(distance, 0.25 * (1 - used));
  if (distance > 0.05) return 1;
  return std::min(most_panels,
                  1 + static_cast<int>(std::ceil(std::log(1 / distance) / std::log(panel_ratio))));
}

std::vector<Direction> half_turn(int intervals) {
  std::vector<Direction> directions(intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    const double angle = pi * i / intervals;
    const bool at_end = i == 0 || i == intervals;
    directions[i] = {std::cos(angle), std::sin(angle), (at_end ? 0.5 : 1.0) / intervals};
  }
  return directions;
}

}  // namespace latticast
