// SPDX-License-Identifier: GPL-3.0-or-later
// Dense linear algebra of small systems, by Eigen: LU with partial pivoting, and tridiagonal QR for
// symmetric eigenproblems. Plain spans, so that Eigen's templates are compiled once
// (docs/decisions/0010-small-matrices.md).
//
// Matrices are square, n x n with 1 <= n <= largest_matrix, column after column; vectors have n
// entries. Nothing is allocated.
#pragma once

#include <cstddef>
#include <span>

namespace latticast {

/// A section's five coordinates and the pressure are six unknowns.
inline constexpr int largest_matrix = 6;

/// Entries of an n x n matrix, and where (row, column) is among them.
constexpr std::size_t entry_count(int n) {
  return static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
}
constexpr std::size_t entry_at(int row, int column, int n) {
  return static_cast<std::size_t>(column) * static_cast<std::size_t>(n) +
         static_cast<std::size_t>(row);
}

/// Solves matrix * x = right; `right` becomes x, `matrix` is destroyed. A singular matrix leaves
/// entries that are not finite, or enormous.
void solve_in_place(std::span<double> matrix, std::span<double> right);

/// Inverse of `matrix`, which is destroyed; as many entries. Singular: as in solve_in_place.
void invert(std::span<double> matrix, std::span<double> inverse);

/// Eigenvalues of a symmetric matrix, ascending; `matrix` is destroyed. Accurate to rounding of the
/// largest one. Entries that are not finite give values that are not.
void symmetric_eigenvalues(std::span<double> matrix, std::span<double> values);

/// The same with unit eigenvectors, column i belonging to values[i]; n x n entries.
void symmetric_eigenvectors(std::span<double> matrix, std::span<double> values,
                            std::span<double> vectors);

/// Euclidean length.
double norm(std::span<const double> vector);

}  // namespace latticast
