// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre quadrature.
#pragma once

#include <vector>

namespace latticast {

/// Abscissae on (-1, 1), ascending, and their weights (which add up to 2).
struct GaussRule {
  std::vector<double> points;
  std::vector<double> weights;
};

/// The rule with `count` >= 1 points, exact for polynomials of degree 2 count - 1. Abscissae are
/// the roots of the Legendre polynomial, found by Newton's method to rounding; symmetric to the
/// last bit.
GaussRule gauss_legendre(int count);

}  // namespace latticast
