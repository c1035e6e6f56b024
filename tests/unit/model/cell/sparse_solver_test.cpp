// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse systems against a matrix whose eigenvalues and solutions are known: the five-point
// Laplacian of a square.
#include "model/cell/sparse_solver.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "design/units.h"

namespace latticast::testing {
namespace {

struct Laplacian {
  int side;
  double shift;  // what every eigenvalue is lowered by

  int size() const { return side * side; }

  SparseSolver solver() const {
    std::vector<std::pair<int, int>> entries;
    for (int i = 0; i < size(); ++i) {
      if (i % side != 0) entries.emplace_back(i, i - 1);
      if (i >= side) entries.emplace_back(i, i - side);
    }
    SparseSolver made(size(), entries);
    for (double& value : made.values()) value = -1;
    for (int i = 0; i < size(); ++i) made.values()[made.place(i, i)] = 4 - shift;
    return made;
  }

  double eigenvalue(int i, int j) const {
    return 4 - shift - 2 * std::cos(pi * i / (side + 1)) - 2 * std::cos(pi * j / (side + 1));
  }

  double mode(int i, int j, int row) const {
    return std::sin(pi * i * (row % side + 1) / (side + 1)) *
           std::sin(pi * j * (row / side + 1) / (side + 1));
  }

  int negative_eigenvalues() const {
    int count = 0;
    for (int i = 1; i <= side; ++i) {
      for (int j = 1; j <= side; ++j) count += eigenvalue(i, j) < 0;
    }
    return count;
  }
};

// Small and large, definite and not: with and without a supernodal factorisation.
TEST(SparseSolver, SolvesAndCountsNegativeEigenvalues) {
  for (const Laplacian& matrix :
       {Laplacian{12, 0}, Laplacian{12, 0.5}, Laplacian{45, 0}, Laplacian{45, 0.5}}) {
    SparseSolver solver = matrix.solver();
    ASSERT_TRUE(solver.factor()) << matrix.side << ' ' << matrix.shift;
    EXPECT_EQ(solver.negative_pivots(), matrix.negative_eigenvalues());
    // Two columns, each a mode: multiplied by its eigenvalue.
    const auto rows = static_cast<std::size_t>(matrix.size());
    std::vector<double> columns(2 * rows);
    for (int row = 0; row < matrix.size(); ++row) {
      columns[row] = matrix.mode(1, 2, row);
      columns[rows + row] = matrix.mode(3, 5, row);
    }
    solver.solve(columns);
    for (int row = 0; row < matrix.size(); ++row) {
      EXPECT_NEAR(columns[row], matrix.mode(1, 2, row) / matrix.eigenvalue(1, 2), 1e-9);
      EXPECT_NEAR(columns[rows + row], matrix.mode(3, 5, row) / matrix.eigenvalue(3, 5), 1e-9);
    }
  }
}

// A matrix that becomes definite again is factored the fast way again.
TEST(SparseSolver, FollowsAMatrixThroughAnEigenvaluesSignAndBack) {
  const Laplacian matrix{45, 0};
  SparseSolver solver = matrix.solver();
  for (const double shift : {0.0, 0.3, 0.0}) {
    for (int i = 0; i < matrix.size(); ++i) solver.values()[solver.place(i, i)] = 4 - shift;
    ASSERT_TRUE(solver.factor());
    EXPECT_EQ(solver.negative_pivots(), (Laplacian{45, shift}.negative_eigenvalues()));
  }
}

}  // namespace
}  // namespace latticast::testing
