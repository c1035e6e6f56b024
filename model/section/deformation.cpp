// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/deformation.h"

#include <cmath>

namespace latticast {

double current_radius_mm(double inner_radius_mm, double reference_radius_mm,
                         const Deformation& at) {
  const double inner = inner_radius_mm + at.inner_growth;
  const double outside =
      (reference_radius_mm - inner_radius_mm) * (reference_radius_mm + inner_radius_mm);
  return std::sqrt(inner * inner + outside / (1 + at.elongation));
}

}  // namespace latticast
