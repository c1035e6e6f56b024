// SPDX-License-Identifier: GPL-3.0-or-later
// Matrix products of a finite element's stiffness: the symmetric one of two tall matrices, blocked
// for registers ([Goto 2008]), and that of a Gauss point's tangent.
#pragma once

#include <cstddef>

namespace latticast {

/// Width that matrices of `size` columns are padded to: a whole number of blocks.
constexpr int product_width(int size) {
  return (size + 7) / 8 * 8;
}

/// result = left^T right, upper triangle (and some of the lower one), over `rows` rows; all three
/// matrices `Width` wide, rows one after the other. Wider vectors where the processor has them,
/// with the same roundings everywhere. Width: 88 or 72.
template <int Width>
void symmetric_product(const double* left, const double* right, std::size_t rows, double* result);

/// result = factor tangent left, of nine rows each: `tangent` 9 x 9, the others `Width` wide.
template <int Width>
void tangent_product(const double* tangent, double factor, const double* left, double* result);

}  // namespace latticast
