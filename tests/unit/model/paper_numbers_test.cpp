// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of docs/model.md#published-and-calculated-numbers, to every printed digit.
#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

const std::vector<double> pressures = {10, 20, 30, 40, 50, 60};

struct Row {
  Segment segment;
  JointModel joint;
  std::array<double, 6> stretch;
  std::array<double, 6> rotation_deg;  // of 100 mm of reference length, magnitude
  double stretch_digit;                // the last printed one
};

const std::vector<Row> table = {
    {paper_segment({36}),
     JointModel::none,
     {1.05447, 1.12696, 1.22143, 1.33466, 1.45386, 1.56810},
     {17.432, 41.215, 73.815, 115.788, 163.082, 209.534},
     1e-5},
    {paper_segment({36}),
     JointModel::paper,
     {1.05214, 1.12044, 1.20828, 1.31402, 1.42869, 1.54309},
     {16.789, 39.215, 69.273, 107.635, 151.676, 196.627},
     1e-5},
    {paper_segment({36}),
     JointModel::clear_span,
     {1.05057, 1.11615, 1.19981, 1.30071, 1.41202, 1.52583},
     {16.356, 37.911, 66.402, 102.540, 144.436, 188.183},
     1e-5},
    {paper_segment({45}),
     JointModel::paper,
     {1.04595, 1.10182, 1.16662, 1.23644, 1.30653, 1.37479},
     {17.933, 40.513, 67.918, 98.746, 130.272, 160.003},
     1e-5},
    {paper_segment({36, 144}),
     JointModel::paper,
     {1.015670, 1.031340, 1.047078, 1.062955, 1.079039, 1.095404},
     {0, 0, 0, 0, 0, 0},
     1e-6},
};

TEST(PaperNumbers, StretchAndRotation) {
  for (const Row& row : table) {
    const Response response = predict(row.segment, with_joint(row.joint), pressures);
    ASSERT_EQ(response.status, Status::ok);
    EXPECT_EQ(response.message, "");
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      const State& state = response.states[i].value();
      EXPECT_NEAR(state.stretch, row.stretch[i], 0.5001 * row.stretch_digit);
      // A right-handed family (angle below 90) unwinds: the twist is left-handed.
      EXPECT_NEAR(-state.twist_rad_per_mm * 100 / degree, row.rotation_deg[i], 0.5001e-3);
      EXPECT_TRUE(state.stable);
      EXPECT_LT(state.error_estimate, 1e-11);
      EXPECT_LT(state.residual, 1e-13);
    }
  }
}

TEST(PaperNumbers, BlockedTorque) {
  const std::array<double, 6> expected = {0.111062, 0.232787, 0.366491,
                                          0.513838, 0.676956, 0.858591};
  const Response response =
      predict(paper_segment({36}), with_joint(JointModel::paper), pressures, {.twist = true});
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const State& state = response.states[i].value();
    EXPECT_NEAR(state.torque_nmm / 1000, expected[i], 0.5001e-6);
    EXPECT_EQ(state.twist_rad_per_mm, 0);
    EXPECT_EQ(state.force_n, 0);
  }
}

State at(double angle_deg, double pressure_kpa, Held held) {
  const Response response = predict(paper_segment({angle_deg}), with_joint(JointModel::paper),
                                    std::vector<double>{pressure_kpa}, held);
  return response.states[0].value();
}

double twist_per_length(double angle_deg, double pressure_kpa) {
  const State state = at(angle_deg, pressure_kpa, {});
  return std::abs(state.twist_rad_per_mm) / state.stretch;
}

/// Where f is largest on 10..85: the best whole degree, then golden section around it.
double best_angle(const std::function<double(double)>& f) {
  double best = 10;
  for (double angle = 11; angle <= 85; ++angle) {
    if (f(angle) > f(best)) best = angle;
  }
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = best - 1;
  double high = best + 1;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    (f(left) > f(right) ? high : low) = f(left) > f(right) ? right : left;
  }
  return 0.5 * (low + high);
}

TEST(PaperNumbers, BestAngleForTwistMovesWithPressure) {
  const std::array<double, 5> expected = {47.81, 42.77, 36.99, 30.98, 25.65};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double pressure = 20 + 10 * static_cast<double>(i);
    const double found =
        best_angle([&](double angle) { return twist_per_length(angle, pressure); });
    EXPECT_NEAR(found, expected[i], 0.0051) << pressure << " kPa";
  }
}

TEST(PaperNumbers, BestAngleForBlockedTorque) {
  const auto torque = [](double angle) { return at(angle, 60, {.twist = true}).torque_nmm / 1000; };
  const double angle = best_angle(torque);
  EXPECT_NEAR(angle, 34.12, 0.0051);
  EXPECT_NEAR(torque(angle), 0.861, 0.5001e-3);
}

TEST(PaperNumbers, StretchGrowsAsTheStripsLieDown) {
  double before = 1;
  for (const double angle : {90., 75., 60., 45., 36., 30., 20., 10.}) {
    const double stretch = at(angle, 40, {}).stretch;
    EXPECT_GT(stretch, before) << angle;
    before = stretch;
  }
}

TEST(PaperNumbers, BareTubesBalloon) {
  const std::array<double, 4> inner = {16, 14, 12, 9};
  const std::array<double, 4> expected = {0.0883164, 0.1884018, 0.3038371, 0.5188067};
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const double mu = 0.05;
    const Response response =
        predict(tube(inner[i], 18, NeoHookean{mu}), {}, std::vector<double>{5, 100});
    EXPECT_EQ(response.status, Status::no_equilibrium);
    EXPECT_FALSE(response.states[1]);
    ASSERT_EQ(response.critical_points.size(), 1U);
    EXPECT_NEAR(response.critical_points[0].pressure_kpa / 1000 / mu, expected[i], 0.5001e-7);
  }
}

}  // namespace
}  // namespace latticast::testing
