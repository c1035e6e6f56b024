// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse symmetric systems: LDL^T without pivoting in an order of least fill ([Davis 2005], by
// Eigen), supernodal L L^T of large ones that are positive definite. The pattern is looked at once;
// matrices follow one another in it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace latticast {

class SparseSolver {
 public:
  /// A matrix of `size` rows whose entries at (row, column), row >= column, may differ from zero;
  /// duplicates are one entry, the diagonal is always there.
  SparseSolver(int size, const std::vector<std::pair<int, int>>& entries);
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;
  SparseSolver& operator=(SparseSolver&&) noexcept;

  /// Where an entry is kept in values().
  std::size_t place(int row, int column) const;
  std::span<double> values();

  /// False where a pivot is zero or not a number.
  bool factor();
  /// Of the matrix that was factored last: as many as its negative eigenvalues.
  int negative_pivots() const;
  /// `right`, one or more columns one after the other, becomes the solution.
  void solve(std::span<double> right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace latticast
