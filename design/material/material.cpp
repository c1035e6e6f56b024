// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/material/material.h"

#include <type_traits>

namespace latticast {

Law scaled(Law law, double factor) {
  std::visit(
      [factor](auto& l) {
        using L = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<L, Linear>) {
          l.youngs_modulus_mpa *= factor;
        } else if constexpr (std::is_same_v<L, Yeoh>) {
          l.c1_mpa *= factor;
          l.c2_mpa *= factor;
          l.c3_mpa *= factor;
        } else {
          l.shear_modulus_mpa *= factor;
        }
      },
      law);
  return law;
}

}  // namespace latticast
