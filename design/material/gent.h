// SPDX-License-Identifier: GPL-3.0-or-later
// Incompressible Gent rubber, W = -mu Jm/2 ln(1 - (I1 - 3)/Jm) [Gent 1996].
#pragma once

#include <cmath>
#include <string_view>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

/// Defined for I1 - 3 < Jm only; infinite or not a number beyond.
struct Gent {
  double shear_modulus_mpa = 0;
  double limit_jm = 0;

  static constexpr std::string_view name = "gent";
  static constexpr LawKey<Gent> keys[] = {
      {"mu", "mu = 0.08", modulus_range, &Gent::shear_modulus_mpa},
      {"jm", "jm = 60", {.low = 1e-3, .high = 1e6}, &Gent::limit_jm}};

  double rest_shear_modulus_mpa() const { return shear_modulus_mpa; }
  double first_invariant_limit() const { return limit_jm; }
  EnergyDensity energy_density(const InPlaneStretch& at) const {
    const EnergyDensity j = first_invariant_minus_3(at);
    const double left = 1 - j.value / limit_jm;
    const double slope = 0.5 * shear_modulus_mpa / left;
    return of_first_invariant(j,
                              -0.5 * shear_modulus_mpa * limit_jm * std::log1p(-j.value / limit_jm),
                              slope, slope / (left * limit_jm));
  }

  friend bool operator==(const Gent&, const Gent&) = default;
};

}  // namespace latticast
