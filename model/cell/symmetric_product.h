// SPDX-License-Identifier: GPL-3.0-or-later
// Product of two tall matrices whose result is symmetric: the inner loop of a finite element's
// stiffness, blocked for registers ([Goto 2008]).
#pragma once

#include <cstddef>

namespace latticast {

/// Width of all three matrices, rows one after the other: a whole number of blocks.
inline constexpr std::size_t product_width = 88;

/// result = left^T right, upper triangle (and some of the lower one), over `rows` rows. Wider
/// vectors where the processor has them, with the same roundings everywhere.
void symmetric_product(const double* left, const double* right, std::size_t rows, double* result);

}  // namespace latticast
