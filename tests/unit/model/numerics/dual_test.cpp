// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/dual.h"

#include <gtest/gtest.h>

namespace latticast {
namespace {

using Pair = Dual<2>;

void expect_pair(const Pair& x, double value, double d0, double d1, double d00, double d01,
                 double d11) {
  EXPECT_NEAR(x.value, value, 1e-14);
  EXPECT_NEAR(x.gradient[0], d0, 1e-14);
  EXPECT_NEAR(x.gradient[1], d1, 1e-14);
  EXPECT_NEAR(x.second(0, 0), d00, 1e-14);
  EXPECT_NEAR(x.second(0, 1), d01, 1e-14);
  EXPECT_NEAR(x.second(1, 0), d01, 1e-14);
  EXPECT_NEAR(x.second(1, 1), d11, 1e-14);
}

const Pair a = Pair::variable(0, 0.3);
const Pair b = Pair::variable(1, 1.7);

TEST(Dual, ProductOfPowers) {  // a^2 b^3, derivatives by hand
  expect_pair(square(a) * b * square(b), 0.09 * 4.913, 0.6 * 4.913, 0.09 * 3 * 2.89, 2 * 4.913,
              0.6 * 3 * 2.89, 0.09 * 6 * 1.7);
}

TEST(Dual, QuotientWithConstants) {  // (2 - a) / (1 + b)
  const double v = 1 / 2.7;
  expect_pair((2.0 + -a) / (b + 1.0), 1.7 * v, -v, -1.7 * v * v, 0, v * v, 2 * 1.7 * v * v * v);
}

TEST(Dual, SquareRoot) {  // sqrt(a b)
  const double root = std::sqrt(0.51);
  expect_pair(sqrt(a * b), root, 1.7 / (2 * root), 0.3 / (2 * root), -0.25 * root / 0.09,
              0.25 / root, -0.25 * root / 2.89);
}

TEST(Dual, Logarithm) {  // ln(1 + a b)
  const double w = 1 / 1.51;
  expect_pair(log1p(a * b), std::log(1.51), 1.7 * w, 0.3 * w, -2.89 * w * w, w * w, -0.09 * w * w);
}

TEST(Dual, AngleOfAVector) {  // polar angle of (a, b): d = (a db - b da)/rho^2
  const double rho2 = 0.09 + 2.89;
  const double cross = 2 * 0.3 * 1.7 / (rho2 * rho2);
  expect_pair(atan2(b, a), std::atan2(1.7, 0.3), -1.7 / rho2, 0.3 / rho2, cross,
              (2.89 - 0.09) / (rho2 * rho2), -cross);
}

TEST(Dual, AngleOfADoubledVectorIsUnchanged) {  // also through second derivatives of the arguments
  const Pair x = a * b + square(b);
  const Pair y = square(a) - b;
  const Pair factor = 1.0 + square(a * b);
  const Pair same = atan2(factor * y, factor * x) - atan2(y, x);
  expect_pair(same, 0, 0, 0, 0, 0, 0);
}

TEST(Dual, PackedHessianOfThreeVariables) {  // x y + 2 y z + 3 x z + 5 z^2
  const auto x = Dual<3>::variable(0, 2);
  const auto y = Dual<3>::variable(1, 3);
  const auto z = Dual<3>::variable(2, 5);
  const auto f = x * y + 2.0 * (y * z) + (x * z) * 3.0 + 5.0 * square(z);
  EXPECT_EQ(f.second(0, 1), 1);
  EXPECT_EQ(f.second(2, 1), 2);
  EXPECT_EQ(f.second(0, 2), 3);
  EXPECT_EQ(f.second(2, 2), 10);
  EXPECT_EQ(f.second(0, 0), 0);
  EXPECT_EQ(f.second(1, 1), 0);
}

}  // namespace
}  // namespace latticast
