// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/material/drucker.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr double scan_step = 0.005;  // of ln(stretch)
constexpr double found_to = 1e-10;

/// A homogeneous test: stretch^exponent is the second stretch in the plane.
struct Test {
  std::string_view name;
  double exponent;
};

constexpr Test tests[] = {
    {"uniaxial tension", -0.5}, {"planar tension", 0}, {"equibiaxial tension", 1}};

InPlaneStretch plane_of(double stretch_1, double stretch_2) {
  const double difference = stretch_1 - stretch_2;
  return {stretch_1 * stretch_2 - 1, difference * difference};
}

bool is_within_limit(const Law& law, const Test& test, double log_stretch) {
  const InPlaneStretch at = plane_of(std::exp(log_stretch), std::exp(test.exponent * log_stretch));
  return first_invariant_minus_3(at).value < first_invariant_limit(law);
}

bool is_stable(const Law& law, const Test& test, double log_stretch) {
  return is_drucker_stable(law, std::exp(log_stretch), std::exp(test.exponent * log_stretch));
}

/// ln(stretch) where the test loses stability.
std::optional<double> loss_in(const Law& law, const Test& test, double largest) {
  double stable = 0;
  while (stable < largest) {
    double next = std::min(stable + scan_step, largest);
    if (!is_within_limit(law, test, next)) return std::nullopt;
    if (is_stable(law, test, next)) {
      stable = next;
      continue;
    }
    while (next - stable > found_to) {
      const double middle = 0.5 * (stable + next);
      (is_stable(law, test, middle) ? stable : next) = middle;
    }
    return next;
  }
  return std::nullopt;
}

}  // namespace

bool is_drucker_stable(const Law& law, double stretch_1, double stretch_2) {
  const EnergyDensity w = energy_density(law, plane_of(stretch_1, stretch_2));
  const double area = stretch_1 * stretch_2;
  // Derivatives of the distortion by the two logarithms; those of the area are the area itself.
  const double by_1 = 2 * stretch_1 * (stretch_1 - stretch_2);
  const double by_2 = 2 * stretch_2 * (stretch_2 - stretch_1);
  const auto second = [&](double by_i, double by_j, double by_ij) {
    return w.by_area * area + w.by_distortion * by_ij + w.by_area_area * area * area +
           w.by_area_distortion * area * (by_i + by_j) + w.by_distortion_distortion * by_i * by_j;
  };
  const double h11 = second(by_1, by_1, 4 * stretch_1 * stretch_1 - 2 * area);
  const double h12 = second(by_1, by_2, -2 * area);
  const double h22 = second(by_2, by_2, 4 * stretch_2 * stretch_2 - 2 * area);
  return h11 > 0 && h11 * h22 > h12 * h12;
}

std::optional<DruckerLoss> drucker_loss(const Law& law, double largest_stretch) {
  std::optional<DruckerLoss> first;
  for (const Test& test : tests) {
    const auto loss = loss_in(law, test, std::log(largest_stretch));
    if (!loss) continue;
    const double stretch = std::exp(*loss);
    if (!first || stretch < first->stretch) first = DruckerLoss{test.name, stretch};
  }
  return first;
}

}  // namespace latticast
