// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/inflated_wall.h"

#include <algorithm>
#include <cmath>

namespace latticast {

double WallStretch::first_invariant_minus_3() const {
  return std::max(0.0, hoop * hoop + axial * axial + shear * shear + across() * across() - 3);
}

double WallStretch::largest_in_wall() const {
  // Eigenvalues of F F^T in the wall: their sum, and their product (hoop axial)^2.
  const double mean = 0.5 * (hoop * hoop + shear * shear + axial * axial);
  const double product = hoop * hoop * axial * axial;
  return std::sqrt(mean + std::sqrt(std::max(0.0, mean * mean - product)));
}

double WallStretch::largest_principal() const {
  return std::max(largest_in_wall(), across());
}

double WallStretch::least_in_wall() const {
  return hoop * axial / largest_in_wall();
}

double WallStretch::along(double angle_rad) const {
  const double around = hoop * std::cos(angle_rad) + shear * std::sin(angle_rad);
  return std::hypot(around, axial * std::sin(angle_rad));
}

double WallStretch::turned_rad(double angle_rad) const {
  const double around = hoop * std::cos(angle_rad) + shear * std::sin(angle_rad);
  return std::atan2(axial * std::sin(angle_rad), around);
}

WallStretch wall_stretch(const Segment& segment, const State& state, double reference_radius_mm,
                         double theta_rad) {
  WallStretch at;
  at.radius_mm = current_radius_mm(segment.inner_radius_mm(), reference_radius_mm,
                                   state.deformation(segment.inner_radius_mm()));
  at.hoop = at.radius_mm / reference_radius_mm;
  at.axial = state.stretch + at.radius_mm * (state.bend_rad_per_mm[0] * std::cos(theta_rad) +
                                             state.bend_rad_per_mm[1] * std::sin(theta_rad));
  at.shear = state.twist_rad_per_mm * at.radius_mm;
  return at;
}

double lengthened_side_rad(const State& state) {
  const auto& bend = state.bend_rad_per_mm;
  return bend[0] == 0 && bend[1] == 0 ? 0 : std::atan2(bend[1], bend[0]);
}

}  // namespace latticast
