// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic linear elasticity, by Young's modulus and Poisson's ratio: strands, and liners of the
// rods model.
#pragma once

#include <limits>
#include <string_view>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

/// 0 <= nu <= 0.5. Where a finite strain is asked of it, it counts as incompressible and
/// neo-Hookean with mu = E/3.
struct Linear {
  double youngs_modulus_mpa = 0;
  double poisson_ratio = 0.5;

  static constexpr std::string_view name = "linear";
  static constexpr LawKey<Linear> keys[] = {
      {"E", "E = 19.46", modulus_range, &Linear::youngs_modulus_mpa},
      {"nu", "", {.low = 0, .high = 0.5}, &Linear::poisson_ratio}};

  double rest_shear_modulus_mpa() const { return youngs_modulus_mpa / 3; }
  double first_invariant_limit() const { return std::numeric_limits<double>::infinity(); }
  EnergyDensity energy_density(const InPlaneStretch& at) const {
    return 0.5 * rest_shear_modulus_mpa() * first_invariant_minus_3(at);
  }

  friend bool operator==(const Linear&, const Linear&) = default;
};

}  // namespace latticast
