// SPDX-License-Identifier: GPL-3.0-or-later
// Strain and turn of a strand that follows the wall: s - 1 with s = |F A|, and the angle from A to
// F A, for A = cosine e_theta + sine e_z and F A = (r/R) (cosine + k R sine) e_theta + Lambda sine
// e_z (docs/model.md#energy). Free of differences of nearly equal numbers.
#pragma once

#include <cmath>

#include "model/numerics/dual.h"

namespace latticast {

template <class Number>
Number stretch_minus_1(const Number& square_minus_1) {
  using std::sqrt;
  return square_minus_1 / (sqrt(square_minus_1 + 1.0) + 1.0);
}

template <class Number>
struct StrandStretch {
  double cosine;
  double sine;
  Number hoop;         ///< (r/R)^2 - 1
  Number hoop_strain;  ///< r/R - 1
  Number shear;        ///< k R sine
  Number elongation;   ///< Lambda - 1
  Number axial;        ///< Lambda^2 - 1

  /// s - 1.
  Number strain() const {
    return stretch_minus_1(hoop * square(shear + cosine) + shear * (shear + 2 * cosine) +
                           axial * (sine * sine));
  }

  /// Signed angle from A to F A, rad.
  Number turn() const {
    using std::atan2;
    const Number hoop_stretch = hoop_strain + 1.0;
    const Number cross = ((elongation - hoop_strain) * cosine - hoop_stretch * shear) * sine;
    const Number dot =
        hoop_stretch * (shear + cosine) * cosine + (elongation + 1.0) * (sine * sine);
    return atan2(cross, dot);
  }
};

}  // namespace latticast
