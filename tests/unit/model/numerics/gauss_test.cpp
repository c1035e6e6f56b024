// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/gauss.h"

#include <cmath>

#include <gtest/gtest.h>

namespace latticast {
namespace {

double integral_of_power(const GaussRule& rule, int power) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    sum += rule.weights[i] * std::pow(rule.points[i], power);
  }
  return sum;
}

TEST(Gauss, IsExactToDegree2nMinus1AndNoFurther) {
  for (const int count : {1, 2, 3, 5, 8, 24, 64}) {
    const GaussRule rule = gauss_legendre(count);
    for (int power = 0; power < 2 * count; ++power) {
      const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
      EXPECT_NEAR(integral_of_power(rule, power), exact, 2e-14) << count << " points, x^" << power;
    }
    if (count < 8) {
      const int power = 2 * count;
      EXPECT_LT(integral_of_power(rule, power), 2.0 / (power + 1) * (1 - 1e-6));
    }
  }
}

TEST(Gauss, KnownFivePointRule) {  // closed form of the roots of P5
  const GaussRule rule = gauss_legendre(5);
  EXPECT_NEAR(rule.points[4], std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3, 1e-15);
  EXPECT_NEAR(rule.points[3], std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3, 1e-15);
  EXPECT_EQ(rule.points[2], 0);
  EXPECT_NEAR(rule.weights[2], 128.0 / 225, 1e-15);
  EXPECT_NEAR(rule.weights[4], (322 - 13 * std::sqrt(70.0)) / 900, 1e-15);
}

TEST(Gauss, PointsAscendAndMirror) {
  const GaussRule rule = gauss_legendre(17);
  for (std::size_t i = 0; i < 17; ++i) {
    EXPECT_EQ(rule.points[i], -rule.points[16 - i]);
    if (i > 0) {
      EXPECT_LT(rule.points[i - 1], rule.points[i]);
    }
  }
}

}  // namespace
}  // namespace latticast
