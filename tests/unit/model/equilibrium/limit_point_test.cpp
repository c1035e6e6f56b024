// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// A bare neo-Hookean capped tube, from its closed forms: for each bore the stretch that leaves no
/// axial force, by bisection; then the largest pressure over the bore, by golden section.
double ballooning_pressure_over_mu(double inner, double outer) {
  const double area = outer * outer - inner * inner;
  const auto force = [&](double stretch, double bore) {
    const double r2 = bore * bore + area / stretch;
    const double c = inner * inner - stretch * bore * bore;
    return stretch * stretch * (area / stretch) -
           (area + c * 0.5 * std::log(r2 / (bore * bore)) - c * std::log(outer / inner)) /
               (stretch * stretch);
  };
  const auto pressure = [&](double bore) {
    double low = 0.3;
    double high = 3;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (force(middle, bore) > 0 ? high : low) = middle;
    }
    const double r2 = bore * bore + area / low;
    const double c = inner * inner - low * bore * bore;
    return std::log(outer * bore / (inner * std::sqrt(r2))) / low -
           c / (2 * low * low) * (1 / (bore * bore) - 1 / r2);
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double from = inner;
  double to = 3 * inner;
  for (int i = 0; i < 80; ++i) {
    const double left = to - golden * (to - from);
    const double right = from + golden * (to - from);
    (pressure(left) > pressure(right) ? to : from) =
        pressure(left) > pressure(right) ? right : left;
  }
  return pressure(0.5 * (from + to));
}

TEST(LimitPoint, MatchesTheClosedFormForAnyWall) {
  std::printf("seed 31\n");
  Random random(31);
  for (int i = 0; i < 40; ++i) {
    const double outer = random.log_between(1, 60);
    const double inner = outer * random.between(0.3, 0.995);
    const double mu = random.log_between(1e-3, 10);
    const double expected = ballooning_pressure_over_mu(inner, outer) * mu * 1000;
    const Response response = predict(tube(inner, outer, NeoHookean{mu}), {},
                                      std::vector<double>{1.5 * expected, 0.7 * expected});
    ASSERT_EQ(response.critical_points.size(), 1U) << response.message;
    const CriticalPoint& limit = response.critical_points[0];
    EXPECT_EQ(limit.kind, CriticalKind::limit_point);
    EXPECT_NEAR(limit.pressure_kpa, expected, 1e-10 * expected);
    EXPECT_LT(limit.state.error_estimate, 1e-10);
    EXPECT_FALSE(response.states[0]);
    EXPECT_TRUE(response.states[1]->stable);
  }
}

TEST(LimitPoint, StatesRightBelowItAreGiven) {
  const double limit = ballooning_pressure_over_mu(14, 18) * 80;
  std::vector<double> pressures;
  for (const double left : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10})
    pressures.push_back(limit * (1 - left));
  pressures.push_back(limit * (1 + 1e-8));
  const Response response = predict(tube(14, 18, NeoHookean{0.08}), {}, pressures);
  double before = 1;
  for (std::size_t i = 0; i + 1 < pressures.size(); ++i) {
    ASSERT_TRUE(response.states[i]) << i << ' ' << response.message;
    EXPECT_TRUE(response.states[i]->stable);
    EXPECT_LT(response.states[i]->smallest_eigenvalue, before);
    before = response.states[i]->smallest_eigenvalue;
  }
  EXPECT_FALSE(response.states.back());
  EXPECT_EQ(response.status, Status::no_equilibrium);
  // The eigenvalue goes with the square root of the pressure that is left.
  EXPECT_NEAR(response.states[5]->smallest_eigenvalue / response.states[4]->smallest_eigenvalue,
              0.1, 0.001);
}

TEST(LimitPoint, IsNamed) {
  const Response response =
      predict(tube(14, 18, NeoHookean{0.08}), {}, std::vector<double>{10, 20, 40});
  EXPECT_EQ(response.message,
            "limit point (ballooning) at 15.07 kPa: no equilibrium above it on this branch");
  EXPECT_EQ(response.message, response.critical_points[0].name);
  EXPECT_TRUE(response.states[0]);
  EXPECT_FALSE(response.states[1]);
  EXPECT_FALSE(response.states[2]);
}

TEST(LimitPoint, HeldLengthGrowsTowardsAnAsymptote) {
  // With lambda = 1 the closed form tends to mu ln(R_o/R_i) as the bore grows, without a maximum.
  const double bound = 80 * std::log(18.0 / 14);
  const Response response =
      predict(tube(14, 18, NeoHookean{0.08}), {}, std::vector<double>{0.9 * bound, 1.1 * bound},
              {.stretch = true});
  EXPECT_TRUE(response.states[0]);
  EXPECT_FALSE(response.states[1]);
  ASSERT_EQ(response.critical_points.size(), 1U);
  EXPECT_EQ(response.critical_points[0].kind, CriticalKind::asymptote);
  EXPECT_NEAR(response.critical_points[0].pressure_kpa, bound, 1e-6 * bound);
}

TEST(LimitPoint, SuctionClosesTheBore) {
  // Closed form at lambda = 1 and a = R_i/1000, from docs/model.md#closed-forms-of-a-bare-tube.
  const double bore = 0.014;
  const double r2 = bore * bore + 18 * 18 - 14 * 14;
  const double c = 14 * 14 - bore * bore;
  const double expected =
      80 * (std::log(18 * bore / (14 * std::sqrt(r2))) - c / 2 * (1 / (bore * bore) - 1 / r2));
  const Response response = predict(tube(14, 18, NeoHookean{0.08}), {},
                                    std::vector<double>{-100, 1.01 * expected}, {.stretch = true});
  EXPECT_TRUE(response.states[0]);
  EXPECT_FALSE(response.states[1]);
  EXPECT_EQ(response.status, Status::no_equilibrium);
  ASSERT_EQ(response.critical_points.size(), 1U) << response.message;
  EXPECT_EQ(response.critical_points[0].kind, CriticalKind::closure);
  EXPECT_NEAR(response.critical_points[0].pressure_kpa / expected, 1,
              1e-9 + 3 * response.critical_points[0].state.error_estimate);
}

TEST(LimitPoint, AxialColumnsBuckleInTwistUnderSuction) {
  // Stiff thin columns at radius R carry the whole cap force P pi R^2 and lose T R^2 of the liner's
  // torsional stiffness mu pi (R^4 - R_i^4)/2: P = -mu (R^4 - R_i^4)/(2 R^4).
  Segment segment = paper_segment({90});
  segment.lattice->thickness_mm = 1e-3;
  segment.lattice->material.law = Linear{1e8, 0.5};
  const double expected = -80 * (std::pow(16.0, 4) - std::pow(12.0, 4)) / (2 * std::pow(16.0, 4));
  const Response response = predict(segment, with_joint(JointModel::none),
                                    std::vector<double>{0.5 * expected, 2 * expected});
  ASSERT_EQ(response.status, Status::ok) << response.message;
  EXPECT_TRUE(response.states[0]->stable);
  EXPECT_FALSE(response.states[1]->stable);
  EXPECT_EQ(response.states[1]->twist_rad_per_mm, 0);
  ASSERT_EQ(response.critical_points.size(), 1U);
  EXPECT_EQ(response.critical_points[0].kind, CriticalKind::bifurcation);
  EXPECT_NEAR(response.critical_points[0].pressure_kpa, expected, 1e-3 * std::abs(expected));
  EXPECT_LT(response.critical_points[0].state.error_estimate, 1e-10);

  const Response held = predict(segment, with_joint(JointModel::none),
                                std::vector<double>{2 * expected}, {.twist = true});
  EXPECT_TRUE(held.states[0]->stable);
  EXPECT_TRUE(held.critical_points.empty());
}

}  // namespace
}  // namespace latticast::testing
