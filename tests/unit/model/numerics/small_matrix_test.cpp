// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/small_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/random_numbers.h"

namespace latticast::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

MatrixXd random_matrix(Random& random, int n) {
  MatrixXd matrix(n, n);
  for (double& entry : matrix.reshaped()) entry = random.between(-1, 1);
  return matrix;
}

std::vector<double> entries(const MatrixXd& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

TEST(SmallMatrix, SolvesAsFullPivotingDoes) {
  std::printf("seed 5\n");
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const int n = random.integer(1, largest_matrix);
    const MatrixXd matrix = random_matrix(random, n);
    const VectorXd expected = VectorXd::NullaryExpr(n, [&] { return random.between(-1, 1); });
    std::vector<double> left = entries(matrix);
    std::vector<double> x = entries(matrix * expected);
    solve_in_place(left, x);
    const Eigen::JacobiSVD<MatrixXd> svd(matrix);
    const double condition = svd.singularValues()[0] / svd.singularValues()[n - 1];
    for (int j = 0; j < n; ++j) {
      ASSERT_NEAR(x[j], expected[j], 20 * epsilon * condition) << "case " << i;
    }
  }
}

TEST(SmallMatrix, ZeroOnTheDiagonalIsNoObstacle) {
  std::vector<double> matrix = {0, 2, 1, 0};
  std::vector<double> x = {3, 8};
  solve_in_place(matrix, x);
  EXPECT_EQ(x[0], 4);
  EXPECT_EQ(x[1], 3);
}

TEST(SmallMatrix, SingularGivesNoFiniteSolution) {
  std::vector<double> matrix = {1, 2, 2, 4};
  std::vector<double> x = {1, 1};
  solve_in_place(matrix, x);
  EXPECT_FALSE(std::isfinite(x[0]) && std::isfinite(x[1]));
}

TEST(SmallMatrix, InverseTimesMatrixIsOne) {
  std::printf("seed 6\n");
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const int n = random.integer(1, largest_matrix);
    // Far from singular, whatever is drawn.
    const MatrixXd matrix = random_matrix(random, n) + 2 * n * MatrixXd::Identity(n, n);
    std::vector<double> destroyed = entries(matrix);
    MatrixXd inverse(n, n);
    invert(destroyed, {inverse.data(), static_cast<std::size_t>(n) * n});
    ASSERT_LT((inverse * matrix - MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 20 * epsilon)
        << "case " << i;
  }
}

/// Symmetric, with the given eigenvalues, over `decades` powers of ten.
struct Symmetric {
  MatrixXd matrix;
  VectorXd values;  // ascending
};
Symmetric random_symmetric(Random& random, int n, double decades) {
  const MatrixXd basis = random_matrix(random, n).householderQr().householderQ();
  VectorXd values(n);
  for (double& value : values) {
    value = random.log_between(std::pow(10, -decades), 1) * (random.chance(0.3) ? -1 : 1);
  }
  const MatrixXd matrix = basis * values.asDiagonal() * basis.transpose();
  std::sort(values.begin(), values.end());
  return {0.5 * (matrix + matrix.transpose()), values};
}

TEST(SmallMatrix, EigenvaluesAreThoseThatTheMatrixWasMadeOf) {
  std::printf("seed 7\n");
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const int n = random.integer(1, largest_matrix);
    const auto [matrix, expected] = random_symmetric(random, n, random.between(0, 8));
    std::vector<double> destroyed = entries(matrix);
    std::vector<double> values(n);
    symmetric_eigenvalues(destroyed, values);
    const double size = expected.cwiseAbs().maxCoeff();
    for (int j = 0; j < n; ++j) {
      ASSERT_NEAR(values[j], expected[j], 20 * epsilon * size) << "case " << i;
    }
  }
}

TEST(SmallMatrix, EigenvectorsAreUnitSquareAndAscending) {
  std::printf("seed 8\n");
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const int n = random.integer(1, largest_matrix);
    const MatrixXd matrix = random_symmetric(random, n, random.between(0, 8)).matrix;
    std::vector<double> destroyed = entries(matrix);
    VectorXd values(n);
    MatrixXd vectors(n, n);
    symmetric_eigenvectors(destroyed, {values.data(), static_cast<std::size_t>(n)},
                           {vectors.data(), static_cast<std::size_t>(n) * n});
    const double size = values.cwiseAbs().maxCoeff();
    const MatrixXd rest = matrix * vectors - vectors * values.asDiagonal();
    ASSERT_LT(rest.cwiseAbs().maxCoeff(), 20 * epsilon * size) << "case " << i;
    const MatrixXd square = vectors.transpose() * vectors - MatrixXd::Identity(n, n);
    ASSERT_LT(square.cwiseAbs().maxCoeff(), 20 * epsilon) << "case " << i;
    for (int j = 1; j < n; ++j) ASSERT_LE(values[j - 1], values[j]) << "case " << i;
  }
}

TEST(SmallMatrix, EqualEigenvaluesStayEqual) {
  std::vector<double> matrix = {2, 0, 0, 0, 2, 0, 0, 0, 2};
  std::vector<double> values(3);
  symmetric_eigenvalues(matrix, values);
  EXPECT_EQ(values, (std::vector<double>{2, 2, 2}));
}

}  // namespace
}  // namespace latticast::testing
