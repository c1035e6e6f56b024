// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/state.h"

#include <cmath>
#include <numbers>

namespace latticast {

double State::bend_magnitude_rad_per_mm() const {
  return std::hypot(bend_rad_per_mm[0], bend_rad_per_mm[1]);
}

double State::bend_direction_rad() const {
  if (bend_rad_per_mm[0] == 0 && bend_rad_per_mm[1] == 0) return 0;
  const double angle = std::atan2(-bend_rad_per_mm[1], -bend_rad_per_mm[0]);
  const double turned = angle < 0 ? angle + 2 * std::numbers::pi : angle;
  return turned < 2 * std::numbers::pi ? turned : 0;
}

Deformation State::deformation(double rest_inner_radius_mm, double axis_rad) const {
  const double cosine = std::cos(axis_rad);
  const double sine = std::sin(axis_rad);
  return {stretch - 1, twist_rad_per_mm, inner_radius_mm - rest_inner_radius_mm,
          cosine * bend_rad_per_mm[0] + sine * bend_rad_per_mm[1],
          cosine * bend_rad_per_mm[1] - sine * bend_rad_per_mm[0]};
}

}  // namespace latticast
