// SPDX-License-Identifier: GPL-3.0-or-later
// Incompressible Mooney-Rivlin rubber, W = c10 (I1 - 3) + c01 (I2 - 3) [Mooney 1940]
// [Rivlin 1948].
#pragma once

#include <limits>
#include <string_view>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

/// I2 - 3 with its derivatives, as accurate.
constexpr EnergyDensity second_invariant_minus_3(const InPlaneStretch& at) {
  const double u = at.area;
  const double s = 1 + u;
  const double w = at.distortion;
  return {.value = w / (s * s) + u * u * (3 + u) / s,
          .by_area = (2 * u * (3 + u * (3 + u)) - 2 * w / s) / (s * s),
          .by_distortion = 1 / (s * s),
          .by_area_area = 2 + (4 + 6 * w / s) / (s * s * s),
          .by_area_distortion = -2 / (s * s * s),
          .by_distortion_distortion = 0};
}

/// Either constant may be negative as long as their sum, half of the rest shear modulus, is not.
struct Mooney {
  double c10_mpa = 0;
  double c01_mpa = 0;

  static constexpr std::string_view name = "mooney";
  static constexpr LawKey<Mooney> keys[] = {
      {"c10", "c10 = 0.03", signed_modulus_range, &Mooney::c10_mpa},
      {"c01", "c01 = 0.01", signed_modulus_range, &Mooney::c01_mpa}};

  double rest_shear_modulus_mpa() const { return 2 * (c10_mpa + c01_mpa); }
  double first_invariant_limit() const { return std::numeric_limits<double>::infinity(); }
  EnergyDensity energy_density(const InPlaneStretch& at) const {
    return c10_mpa * first_invariant_minus_3(at) + c01_mpa * second_invariant_minus_3(at);
  }

  friend bool operator==(const Mooney&, const Mooney&) = default;
};

}  // namespace latticast
