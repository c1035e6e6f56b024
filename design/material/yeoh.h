// SPDX-License-Identifier: GPL-3.0-or-later
// Incompressible Yeoh rubber, W = c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3 [Yeoh 1993].
#pragma once

#include <limits>
#include <string_view>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

struct Yeoh {
  double c1_mpa = 0;
  double c2_mpa = 0;
  double c3_mpa = 0;

  static constexpr std::string_view name = "yeoh";
  static constexpr LawKey<Yeoh> keys[] = {{"c1", "c1 = 0.04", modulus_range, &Yeoh::c1_mpa},
                                          {"c2", "", signed_modulus_range, &Yeoh::c2_mpa},
                                          {"c3", "", signed_modulus_range, &Yeoh::c3_mpa}};

  double rest_shear_modulus_mpa() const { return 2 * c1_mpa; }
  double first_invariant_limit() const { return std::numeric_limits<double>::infinity(); }
  EnergyDensity energy_density(const InPlaneStretch& at) const {
    const EnergyDensity j = first_invariant_minus_3(at);
    return of_first_invariant(j, j.value * (c1_mpa + j.value * (c2_mpa + j.value * c3_mpa)),
                              c1_mpa + j.value * (2 * c2_mpa + 3 * j.value * c3_mpa),
                              2 * c2_mpa + 6 * j.value * c3_mpa);
  }

  friend bool operator==(const Yeoh&, const Yeoh&) = default;
};

}  // namespace latticast
