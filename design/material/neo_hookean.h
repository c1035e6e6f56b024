// SPDX-License-Identifier: GPL-3.0-or-later
// Incompressible neo-Hookean rubber, W = mu/2 (I1 - 3); [Wang] (2).
#pragma once

#include <limits>
#include <string_view>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

struct NeoHookean {
  double shear_modulus_mpa = 0;

  static constexpr std::string_view name = "neo-hookean";
  static constexpr LawKey<NeoHookean> keys[] = {
      {"mu", "mu = 0.08", modulus_range, &NeoHookean::shear_modulus_mpa}};

  double rest_shear_modulus_mpa() const { return shear_modulus_mpa; }
  double first_invariant_limit() const { return std::numeric_limits<double>::infinity(); }
  EnergyDensity energy_density(const InPlaneStretch& at) const {
    return 0.5 * shear_modulus_mpa * first_invariant_minus_3(at);
  }

  friend bool operator==(const NeoHookean&, const NeoHookean&) = default;
};

}  // namespace latticast
