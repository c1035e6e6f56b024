// SPDX-License-Identifier: GPL-3.0-or-later
// A neo-Hookean tube under stretch, twist and inflation has closed forms
// (docs/model.md#closed-forms-of-a-bare-tube).
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

struct Loads {
  double pressure_mpa;
  double reduced_force_n;
  double torque_nmm;
};

Loads closed_form(double mu, double inner, double outer, double stretch, double bore,
                  double twist) {
  const double area = outer * outer - inner * inner;
  const double r_o = std::sqrt(bore * bore + area / stretch);
  const double c = inner * inner - stretch * bore * bore;
  const double s = r_o * r_o - bore * bore;
  const double fourth = std::pow(r_o, 4) - std::pow(bore, 4);
  const double d2 = twist * twist;
  const double pressure = std::log(outer * bore / (inner * r_o)) / stretch + d2 * s / 2 -
                          c / (2 * stretch * stretch) * (1 / (bore * bore) - 1 / (r_o * r_o));
  const double force =
      stretch * stretch * s -
      (stretch * s / 2 + c * std::log(r_o / bore) + area / 2 - c * std::log(outer / inner)) /
          (stretch * stretch) -
      d2 * fourth / 4;
  return {mu * pressure, pi * mu * force, pi / 2 * mu * stretch * twist * fourth};
}

Loads from_energy(const Segment& segment, double stretch, double bore, double twist) {
  const Section section = prepare_section(segment, {});
  const Deformation q{stretch - 1, twist, bore - segment.inner_radius_mm()};
  const auto energy = stored_energy(section, make_quadrature(section, 24, 24), q);
  const double pressure = energy->gradient[2] / (2 * pi * bore * stretch);
  return {pressure, energy->gradient[0] - pressure * pi * bore * bore, energy->gradient[1]};
}

void expect_same(const Loads& found, const Loads& expected, double mu, double area) {
  EXPECT_NEAR(found.pressure_mpa, expected.pressure_mpa, 1e-9 * std::abs(expected.pressure_mpa));
  // The reduced force is a difference of terms of the size of mu times the area.
  EXPECT_NEAR(found.reduced_force_n, expected.reduced_force_n,
              1e-9 * std::abs(expected.reduced_force_n) + 1e-12 * mu * area);
  EXPECT_NEAR(found.torque_nmm, expected.torque_nmm, 1e-9 * std::abs(expected.torque_nmm));
}

TEST(ClosedForms, CheckPoint) {
  const Loads loads = from_energy(tube(14, 18, NeoHookean{0.08}), 1.3, 15.1, 0.01);
  EXPECT_NEAR(loads.pressure_mpa * 1000, 7.95825717, 0.5e-8);
  EXPECT_NEAR(loads.reduced_force_n, 21.3696574, 0.5e-7);
  EXPECT_NEAR(loads.torque_nmm, 89.1881025, 0.5e-7);
}

TEST(ClosedForms, RandomStates) {
  std::printf("seed 21\n");
  Random random(21);
  for (int i = 0; i < 200; ++i) {
    const double outer = random.log_between(1, 60);
    const double inner = outer * random.between(0.3, 0.99);
    const double mu = random.log_between(1e-3, 10);
    const double stretch = random.between(0.6, 2.5);
    const double bore = inner * random.between(1.2, 2.5);
    const double twist = random.between(-0.6, 0.6) / outer;
    const Segment segment = tube(inner, outer, NeoHookean{mu});
    expect_same(from_energy(segment, stretch, bore, twist),
                closed_form(mu, inner, outer, stretch, bore, twist), mu, outer * outer);
  }
}

TEST(ClosedForms, InflatedTubeIsInBalance) {
  const Segment segment = tube(14, 18, NeoHookean{0.08});
  const Response response = predict(segment, {}, std::vector<double>{5, 10, 14});
  ASSERT_EQ(response.status, Status::ok);
  for (const auto& state : response.states) {
    const Loads loads = closed_form(0.08, 14, 18, state->stretch, state->inner_radius_mm, 0);
    EXPECT_NEAR(loads.pressure_mpa * 1000, state->pressure_kpa, 1e-9 * state->pressure_kpa);
    EXPECT_NEAR(loads.reduced_force_n, 0, 1e-9);
    EXPECT_EQ(state->twist_rad_per_mm, 0);
  }
}

TEST(ClosedForms, HeldLengthTakesTheReducedForce) {
  const Segment segment = tube(14, 18, NeoHookean{0.08});
  const Response response =
      predict(segment, {}, std::vector<double>{-20, 5, 10, 18}, {.stretch = true});
  ASSERT_EQ(response.status, Status::ok);
  for (const auto& state : response.states) {
    const Loads loads = closed_form(0.08, 14, 18, 1, state->inner_radius_mm, 0);
    EXPECT_NEAR(loads.pressure_mpa * 1000, state->pressure_kpa,
                1e-9 * std::abs(state->pressure_kpa));
    EXPECT_NEAR(loads.reduced_force_n, state->force_n, 1e-9 * std::abs(state->force_n));
    EXPECT_EQ(state->stretch, 1);
  }
}

TEST(ClosedForms, SmallPressureIsLame) {
  // Incompressible, closed ends: no elongation, u(R_i) = P R_i R_o^2 / (2 mu (R_o^2 - R_i^2)).
  const Segment segment = tube(12, 16, NeoHookean{0.08});
  const double pressure_kpa = 1e-5;
  const Response response = predict(segment, {}, std::vector<double>{pressure_kpa});
  const double expected = pressure_kpa / 1000 * 12 * 256 / (2 * 0.08 * (256 - 144));
  EXPECT_NEAR(response.states[0]->inner_radius_mm - 12, expected, 1e-6 * expected);
  EXPECT_NEAR(response.states[0]->stretch - 1, 0, 1e-6 * expected / 12);
}

}  // namespace
}  // namespace latticast::testing
