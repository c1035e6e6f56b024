// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre quadrature in extended precision, for references that errors are measured with.
#pragma once

#include <vector>

namespace latticast {

/// Abscissae on (-1, 1), ascending, and their weights; both to the rounding of long double.
struct LongGaussRule {
  std::vector<long double> points;
  std::vector<long double> weights;
};

/// The rule with `count` >= 2 points.
LongGaussRule long_gauss(int count);

}  // namespace latticast
