// SPDX-License-Identifier: GPL-3.0-or-later
// Supernodal Cholesky factorisation L L^T of large sparse matrices ([Chen 2008], by CHOLMOD). The
// library is loaded when the first system is large enough for it, and nothing is linked to it.
#pragma once

#include <memory>
#include <span>

namespace latticast {

/// The lower triangle of a symmetric matrix by columns, rows ascending in each: where its columns
/// start among the entries, the entries' rows and their values.
struct LowerTriangle {
  std::span<const int> starts;  ///< one more than columns
  std::span<const int> rows;
  std::span<const double> values;
};

class SupernodalCholesky {
 public:
  /// Looks at the pattern. Null where the library is not there. The matrix keeps its place in
  /// memory while its values change.
  static std::unique_ptr<SupernodalCholesky> make(const LowerTriangle& matrix);
  ~SupernodalCholesky();

  /// False where the matrix is not positive definite.
  bool factor();
  /// `right`, one or more columns, becomes the solution. Precondition: factored.
  void solve(std::span<double> right);

 private:
  struct Factor;
  explicit SupernodalCholesky(std::unique_ptr<Factor> factor);

  std::unique_ptr<Factor> factor_;
};

}  // namespace latticast
