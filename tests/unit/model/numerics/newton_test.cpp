// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/newton.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace latticast {
namespace {

// x^2 + y^2 = 4, x y = 1, in the first quadrant: x + y = sqrt 6, x - y = sqrt 2.
bool circle_and_hyperbola(std::span<const double> x, std::span<double> f, std::span<double> j) {
  f[0] = x[0] * x[0] + x[1] * x[1] - 4;
  f[1] = x[0] * x[1] - 1;
  j[0] = 2 * x[0];
  j[1] = x[1];
  j[2] = 2 * x[1];
  j[3] = x[0];
  return true;
}

TEST(Newton, ConvergesToRounding) {
  NewtonSolver solver(2);
  std::array<double, 2> x{2, 0.3};
  ASSERT_TRUE(solver.solve(x, circle_and_hyperbola, 12));
  EXPECT_NEAR(x[0], (std::sqrt(6.0) + std::sqrt(2.0)) / 2, 1e-15);
  EXPECT_NEAR(x[1], (std::sqrt(6.0) - std::sqrt(2.0)) / 2, 1e-15);
  EXPECT_LE(solver.iterations(), 6);
}

TEST(Newton, LastEvaluationIsAtTheSolution) {
  NewtonSolver solver(2);
  std::array<double, 2> x{2, 0.3};
  std::array<double, 2> last{};
  const auto recorded = [&](std::span<const double> at, std::span<double> f, std::span<double> j) {
    last = {at[0], at[1]};
    return circle_and_hyperbola(at, f, j);
  };
  ASSERT_TRUE(solver.solve(x, recorded, 12));
  EXPECT_EQ(last, x);
}

TEST(Newton, FailuresAreAnswers) {
  NewtonSolver solver(1);
  const auto no_root = [](std::span<const double> x, std::span<double> f, std::span<double> j) {
    f[0] = x[0] * x[0] + 1;
    j[0] = 2 * x[0];
    return true;
  };
  std::array<double, 1> x{0.7};
  EXPECT_FALSE(solver.solve(x, no_root, 12));
  x = {0};  // singular Jacobian
  EXPECT_FALSE(solver.solve(x, no_root, 12));
  const auto undefined = [](std::span<const double>, std::span<double>, std::span<double>) {
    return false;
  };
  EXPECT_FALSE(solver.solve(x, undefined, 12));
}

TEST(Newton, StepsBackFromWhereTheFunctionIsUndefined) {
  // ln x = -3 from x = 0.2: the full step reaches x = -0.08.
  NewtonSolver solver(1);
  const auto logarithm = [](std::span<const double> x, std::span<double> f, std::span<double> j) {
    if (!(x[0] > 0)) return false;
    f[0] = std::log(x[0]) + 3;
    j[0] = 1 / x[0];
    return true;
  };
  std::array<double, 1> x{0.2 * std::exp(1.0)};
  ASSERT_TRUE(solver.solve(x, logarithm, 30));
  EXPECT_NEAR(x[0], std::exp(-3.0), 1e-15);
}

}  // namespace
}  // namespace latticast
