// SPDX-License-Identifier: GPL-3.0-or-later
// Random designs that bend: each state verified by a separate balance of all five coordinates that
// uses no symmetry; each absence explained; the error estimate held against the truth.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/section/quadrature.h"
#include "model/segment_response.h"
#include "tests/unit/model/linear_check.h"
#include "tests/unit/model/random_examples.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

double scaled_difference(const Segment& segment, const State& a, const State& b) {
  const double outer = segment.outer_radius_mm();
  return std::max({std::abs(a.stretch - b.stretch),
                   std::abs(a.twist_rad_per_mm - b.twist_rad_per_mm) * outer,
                   std::abs(a.bend_rad_per_mm[0] - b.bend_rad_per_mm[0]) * outer,
                   std::abs(a.bend_rad_per_mm[1] - b.bend_rad_per_mm[1]) * outer,
                   std::abs(a.inner_radius_mm - b.inner_radius_mm) / segment.inner_radius_mm()});
}

bool is_finite(const State& state) {
  for (const double number :
       {state.stretch, state.twist_rad_per_mm, state.bend_rad_per_mm[0], state.bend_rad_per_mm[1],
        state.inner_radius_mm, state.outer_radius_mm, state.torque_nmm, state.moment_nmm[0],
        state.moment_nmm[1], state.force_n, state.residual, state.error_estimate,
        state.smallest_eigenvalue}) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

void expect_verified(const RandomExample& example, const Section& section, const State& state) {
  ASSERT_TRUE(is_finite(state));
  const Quadrature fine = make_quadrature(section, 32, 24, 97);
  const Deformation q = state.deformation(section.inner_radius_mm, section.axis_rad);
  const Held& held = example.held;
  const auto balance = full_balance(section, fine, q, state.pressure_kpa / 1000,
                                    {held.stretch, held.twist, false, held.bend, held.bend});
  ASSERT_TRUE(balance);
  EXPECT_LE(missing_step(*balance), std::max(1e-9, 3 * state.error_estimate));
  EXPECT_LT(state.error_estimate, 1e-6);
  if (std::abs(state.smallest_eigenvalue) < 1e-8) return;
  EXPECT_EQ(state.stable, positive_definite(balance->stiffness)) << state.smallest_eigenvalue;
}

/// A missing state is explained by the branch's end before its pressure or by a reason in words.
void expect_explained(const Response& response, double pressure_kpa) {
  for (const CriticalPoint& limit : response.critical_points) {
    if (limit.kind != CriticalKind::bifurcation && limit.pressure_kpa * pressure_kpa > 0 &&
        std::abs(limit.pressure_kpa) <= std::abs(pressure_kpa)) {
      return;
    }
  }
  EXPECT_EQ(response.status, Status::not_converged);
  EXPECT_TRUE(response.message.find("stretch limit (Gent)") != std::string::npos ||
              response.message.find("its law ends at") != std::string::npos ||
              response.message.find("verge of instability") != std::string::npos ||
              response.message.find("hundredfold") != std::string::npos)
      << response.message;
}

TEST(RandomBending, EveryStateIsVerifiedOrItsAbsenceExplained) {
  const unsigned seed = 81;
  std::printf("seed %u\n", seed);
  Random random(seed);
  int states = 0;
  int missing = 0;
  int bent = 0;
  for (int i = 0; i < 300; ++i) {
    const RandomExample example = random_bending_example(random);
    const PreparedSegment prepared = prepare_segment(example.segment, {});
    const Response response = predict(prepared, example.pressures_kpa, example.held);
    for (std::size_t j = 0; j < response.states.size(); ++j) {
      SCOPED_TRACE("design " + std::to_string(i) + ", " + std::to_string(example.pressures_kpa[j]) +
                   " kPa; " + response.message);
      if (response.states[j]) {
        ++states;
        const double bend = response.states[j]->bend_magnitude_rad_per_mm();
        if (bend * example.segment.outer_radius_mm() > 1e-3) ++bent;
        expect_verified(example, std::get<Section>(prepared.section), *response.states[j]);
      } else {
        ++missing;
        expect_explained(response, example.pressures_kpa[j]);
      }
    }
  }
  std::printf("%d states verified, %d of them bent, %d absences explained\n", states, bent,
              missing);
  EXPECT_GT(states, 2 * missing);
  EXPECT_GT(bent, 60);
}

TEST(RandomBending, LongStepsStayOnTheBranchOfShortOnes) {
  const unsigned seed = 82;
  std::printf("seed %u\n", seed);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const RandomExample example = random_bending_example(random);
    const PreparedSegment prepared = prepare_segment(example.segment, {});
    const double end = example.pressures_kpa.back();
    std::vector<double> fine;
    for (int j = 1; j <= 60; ++j) fine.push_back(end * j / 60);
    const Response far = predict(prepared, std::span(&end, 1), example.held);
    const Response near = predict(prepared, fine, example.held);
    SCOPED_TRACE("design " + std::to_string(i) + "; " + far.message + "; " + near.message);
    ASSERT_EQ(far.states[0].has_value(), near.states.back().has_value());
    if (!far.states[0]) continue;
    const State& a = *far.states[0];
    const State& b = *near.states.back();
    EXPECT_LE(scaled_difference(example.segment, a, b),
              1e-9 + 3 * (a.error_estimate + b.error_estimate));
  }
}

TEST(RandomBending, ErrorEstimateIsTrue) {
  // Coarse quadratures, whose true error is seen against a fine one.
  const unsigned seed = 83;
  std::printf("seed %u\n", seed);
  Random random(seed);
  int compared = 0;
  double least = 1e300;
  double most = 0;
  for (int i = 0; i < 150; ++i) {
    const RandomExample example = random_bending_example(random);
    SolverOptions coarse;
    coarse.fixed_quadrature = random.integer(4, 7);
    SolverOptions fine;
    fine.fixed_quadrature = 40;
    const PreparedSegment prepared = prepare_segment(example.segment, {});
    const std::span pressure(example.pressures_kpa.data(), 1);
    const auto rough = predict(prepared, pressure, example.held, coarse);
    if (!rough.states[0] || rough.states[0]->bend_magnitude_rad_per_mm() == 0) continue;
    const auto exact = predict(prepared, pressure, example.held, fine);
    if (!exact.states[0]) continue;
    const double truth = scaled_difference(example.segment, *rough.states[0], *exact.states[0]);
    // Below 1e-11 rounding speaks; above 0.001 an estimate linear in the error need not hold.
    if (truth < 1e-11 || truth > 0.001) continue;
    ++compared;
    least = std::min(least, rough.states[0]->error_estimate / truth);
    most = std::max(most, rough.states[0]->error_estimate / truth);
  }
  std::printf("estimate / true error of %d designs: %.3f to %.3f\n", compared, least, most);
  EXPECT_GT(compared, 10);
  EXPECT_GT(least, 0.9);
  EXPECT_LT(most, 6);
}

}  // namespace
}  // namespace latticast::testing
