// SPDX-License-Identifier: GPL-3.0-or-later
// Random designs over the whole range that can be asked for: each state is verified by a separate
// evaluation, and a state that is missing has a reason.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/unit/model/random_examples.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

/// Gaussian elimination with row pivoting.
Vector solve(Matrix a, Vector b) {
  for (int i = 0; i < 3; ++i) {
    int pivot = i;
    for (int r = i + 1; r < 3; ++r) {
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    }
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (int r = i + 1; r < 3; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (int c = i; c < 3; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  for (int i = 2; i >= 0; --i) {
    for (int c = i + 1; c < 3; ++c) b[i] -= a[i][c] * b[c];
    b[i] /= a[i][i];
  }
  return b;
}

/// The Newton step that a state still lacks under 64-point quadrature, in scaled coordinates; the
/// wall in panels, as bores that are nearly closed and rubbers near their limit need.
double missing_step(const RandomExample& example, const State& state) {
  const Section section = prepare_section(example.segment, example.model);
  const Deformation q = state.deformation(section.inner_radius_mm);
  const int panels = bore_panels_for(section, q) > 1 ? 14 : 1;
  const auto energy =
      stored_energy(section, make_quadrature(section, 64, 64, 1, panels), q, std::array{0, 1, 2});
  if (!energy) return std::numeric_limits<double>::infinity();
  const SectionEnergy cavity = cavity_growth(section, q);
  const Vector scale = {1, 1 / section.outer_radius_mm, section.inner_radius_mm};
  const std::array<bool, 3> fixed = {example.held.stretch, example.held.twist, false};
  Matrix stiffness{};
  Vector imbalance{};
  for (int i = 0; i < 3; ++i) {
    stiffness[i][i] = 1;
    if (fixed[i]) continue;
    const double pressure = state.pressure_kpa / 1000;
    imbalance[i] = (energy->gradient[i] - pressure * cavity.gradient[i]) * scale[i];
    for (int j = 0; j < 3; ++j) {
      const double second = energy->second(i, j) - pressure * cavity.second(i, j);
      stiffness[i][j] = fixed[j] ? 0 : second * scale[i] * scale[j];
    }
  }
  double largest = 0;
  for (const double step : solve(stiffness, imbalance)) largest = std::max(largest, std::abs(step));
  return largest;
}

double scaled_difference(const Segment& segment, const State& a, const State& b) {
  return std::max({std::abs(a.stretch - b.stretch),
                   std::abs(a.twist_rad_per_mm - b.twist_rad_per_mm) * segment.outer_radius_mm(),
                   std::abs(a.inner_radius_mm - b.inner_radius_mm) / segment.inner_radius_mm()});
}

void expect_verified(const RandomExample& example, const State& state) {
  // A stretch of 1 + 1e-16 cannot be told from 1: with a stiff lattice its rounding alone is a
  // force.
  const double rounding =
      1e-15 * std::max(1.0, state.inner_radius_mm / example.segment.inner_radius_mm());
  EXPECT_LE(missing_step(example, state), std::max(1e-9, 3 * state.error_estimate) + rounding);
  EXPECT_EQ(state.stable, state.smallest_eigenvalue > 0);
  EXPECT_GT(state.stretch, 0);
  EXPECT_GT(state.inner_radius_mm, 0);
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
              response.message.find("verge of instability") != std::string::npos ||
              response.message.find("hundredfold") != std::string::npos)
      << response.message;
}

TEST(RandomDesigns, EveryStateIsVerifiedOrItsAbsenceExplained) {
  const unsigned seed = 41;
  std::printf("seed %u\n", seed);
  Random random(seed);
  int states = 0;
  int missing = 0;
  for (int i = 0; i < 1500; ++i) {
    const RandomExample example = random_straight_example(random);
    const Response response =
        predict(example.segment, example.model, example.pressures_kpa, example.held);
    for (std::size_t j = 0; j < response.states.size(); ++j) {
      SCOPED_TRACE("design " + std::to_string(i) + ", " + std::to_string(example.pressures_kpa[j]) +
                   " kPa; " + response.message);
      if (response.states[j]) {
        ++states;
        expect_verified(example, *response.states[j]);
      } else {
        ++missing;
        expect_explained(response, example.pressures_kpa[j]);
      }
    }
  }
  std::printf("%d states verified, %d absences explained\n", states, missing);
  EXPECT_GT(states, 5 * missing);
}

TEST(RandomDesigns, OneByOneIsTheSameAsTogether) {
  const unsigned seed = 42;
  std::printf("seed %u\n", seed);
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    const RandomExample example = random_straight_example(random);
    const Response together =
        predict(example.segment, example.model, example.pressures_kpa, example.held);
    for (std::size_t j = 0; j < together.states.size(); ++j) {
      SCOPED_TRACE("design " + std::to_string(i) + "; " + together.message);
      const Response alone = predict(example.segment, example.model,
                                     std::span(&example.pressures_kpa[j], 1), example.held);
      if (together.status == Status::not_converged) continue;
      ASSERT_EQ(alone.states[0].has_value(), together.states[j].has_value()) << alone.message;
      if (!alone.states[0]) continue;
      const State& a = *alone.states[0];
      const State& b = *together.states[j];
      EXPECT_LE(scaled_difference(example.segment, a, b),
                1e-9 + 3 * (a.error_estimate + b.error_estimate));
    }
  }
}

TEST(RandomDesigns, LongStepsStayOnTheBranchOfShortOnes) {
  const unsigned seed = 45;
  std::printf("seed %u\n", seed);
  Random random(seed);
  for (int i = 0; i < 500; ++i) {
    const RandomExample example = random_straight_example(random);
    const double end = example.pressures_kpa.back();
    std::vector<double> fine;
    for (int j = 1; j <= 100; ++j) fine.push_back(end * j / 100);
    const Response far = predict(example.segment, example.model, std::span(&end, 1), example.held);
    const Response near = predict(example.segment, example.model, fine, example.held);
    SCOPED_TRACE("design " + std::to_string(i) + "; " + far.message + "; " + near.message);
    ASSERT_EQ(far.states[0].has_value(), near.states.back().has_value());
    if (!far.states[0]) continue;
    const State& a = *far.states[0];
    const State& b = *near.states.back();
    EXPECT_LE(scaled_difference(example.segment, a, b),
              1e-9 + 3 * (a.error_estimate + b.error_estimate));
  }
}

TEST(RandomDesigns, ErrorEstimateIsTrue) {
  // Coarse quadratures, whose true error is seen against a fine one.
  const unsigned seed = 43;
  std::printf("seed %u\n", seed);
  Random random(seed);
  int compared = 0;
  double least = 1e300;
  double most = 0;
  for (int i = 0; compared < 100; ++i) {
    RandomExample example = random_straight_example(random);
    SolverOptions coarse;
    coarse.fixed_quadrature = random.integer(2, 6);
    SolverOptions fine;
    fine.fixed_quadrature = 60;
    const auto rough =
        predict(example.segment, example.model, example.pressures_kpa, example.held, coarse);
    const auto exact =
        predict(example.segment, example.model, example.pressures_kpa, example.held, fine);
    if (!rough.states[0] || !exact.states[0]) continue;
    const double truth = scaled_difference(example.segment, *rough.states[0], *exact.states[0]);
    const double estimate = rough.states[0]->error_estimate;
    // Below 1e-11 rounding speaks; above 0.001 an estimate linear in the error need not hold.
    if (truth < 1e-11 || truth > 0.001) continue;
    ++compared;
    least = std::min(least, estimate / truth);
    most = std::max(most, estimate / truth);
  }
  std::printf("estimate / true error of %d designs: %.3f to %.3f\n", compared, least, most);
  EXPECT_GT(least, 0.9);
  EXPECT_LT(most, 6);
}

TEST(RandomDesigns, AdaptiveQuadratureKeepsItsPromise) {
  const unsigned seed = 44;
  std::printf("seed %u\n", seed);
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const RandomExample example = random_straight_example(random);
    SolverOptions fine;
    fine.fixed_quadrature = 64;
    const auto found = predict(example.segment, example.model, example.pressures_kpa, example.held);
    const auto exact =
        predict(example.segment, example.model, example.pressures_kpa, example.held, fine);
    for (std::size_t j = 0; j < found.states.size(); ++j) {
      if (!found.states[j] || !exact.states[j]) continue;
      const State& a = *found.states[j];
      EXPECT_LE(scaled_difference(example.segment, a, *exact.states[j]),
                1e-11 + 3 * (a.error_estimate + exact.states[j]->error_estimate))
          << "design " << i << ", estimate " << a.error_estimate;
    }
  }
}

}  // namespace
}  // namespace latticast::testing
