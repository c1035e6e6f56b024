// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/root_search.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "tests/random_numbers.h"

namespace latticast::testing {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <class Function>
double root(const Function& f, double a, double b, double tolerance, int* calls = nullptr) {
  const auto counted = [&](double x) {
    if (calls) ++*calls;
    return f(x);
  };
  return bracketed_root(counted, a, f(a), b, f(b), tolerance);
}

TEST(RootSearch, FindsKnownRootsFromEitherSide) {
  const auto cubic = [](double x) { return x * x * x - 2; };
  for (const double tolerance : {1e-3, 1e-9, 0.0}) {
    EXPECT_NEAR(root(cubic, 0, 2, tolerance), std::cbrt(2.0), tolerance + 2 * epsilon);
    EXPECT_NEAR(root(cubic, 2, 0, tolerance), std::cbrt(2.0), tolerance + 2 * epsilon);
  }
  EXPECT_NEAR(root([](double x) { return std::cos(x) - x; }, 0, 1, 0), 0.7390851332151607, 2e-16);
}

TEST(RootSearch, RandomMonotoneFunctions) {
  std::printf("seed 11\n");
  Random random(11);
  int calls = 0;
  constexpr int cases = 2000;
  for (int i = 0; i < cases; ++i) {
    const double expected = random.between(-1, 1);
    const double steep = random.log_between(1e-3, 1e3);
    const double sign = random.chance(0.5) ? 1 : -1;
    const auto f = [&](double x) {
      const double d = x - expected;
      return sign * (std::sinh(std::min(30.0, steep) * d) + d * std::abs(d) * steep);
    };
    const double a = expected - random.log_between(1e-6, 10);
    const double b = expected + random.log_between(1e-6, 10);
    ASSERT_NEAR(root(f, a, b, 1e-12, &calls), expected, 1e-12) << "case " << i;
  }
  // Bisection takes 33 to 44.
  EXPECT_LT(calls, 16 * cases);
}

TEST(RootSearch, FlatAndSteepRootsConvergeToo) {
  // Ninth power: secant methods that keep one end creep.
  int calls = 0;
  const auto flat = [](double x) { return std::pow(x - 0.3, 9); };
  EXPECT_NEAR(root(flat, 0, 1, 1e-10, &calls), 0.3, 1e-10);
  EXPECT_LT(calls, 80);
  calls = 0;
  const auto jump = [](double x) { return x < 0.7 ? -1.0 : 1e6; };
  EXPECT_NEAR(root(jump, 0, 1, 1e-12, &calls), 0.7, 1e-12);
  EXPECT_LT(calls, 80);
}

TEST(RootSearch, InfiniteValuesAreASide) {
  const auto f = [](double x) { return x < 0.25 ? -HUGE_VAL : (x > 0.5 ? HUGE_VAL : x - 0.4); };
  EXPECT_NEAR(root(f, 0, 1, 1e-12), 0.4, 1e-12);
}

TEST(RootSearch, AnEndThatIsARootIsIt) {
  const auto f = [](double x) { return x; };
  EXPECT_EQ(root(f, 0, 1, 1e-9), 0);
  EXPECT_EQ(root(f, -1, 0, 1e-9), 0);
}

TEST(RootSearch, StaysInTheBracketWhereverItIsDriven) {
  std::printf("seed 12\n");
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    double low = 0;
    double high = 1;
    RootSearch search(low, -random.log_between(1e-9, 1e9), high, random.log_between(1e-9, 1e9));
    for (int step = 0; step < 40 && high - low > 1e-12; ++step) {
      const double x = search.next(1e-3);
      ASSERT_GT(x, low) << "case " << i;
      ASSERT_LT(x, high) << "case " << i;
      const double value = random.log_between(1e-9, 1e9) * (random.chance(0.5) ? -1 : 1);
      search.narrow(x, value);
      (value < 0 ? low : high) = x;
    }
  }
}

}  // namespace
}  // namespace latticast::testing
