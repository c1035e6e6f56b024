// SPDX-License-Identifier: GPL-3.0-or-later
// The error that a prediction states against the error that it has, with the settings that users
// get: quadrature, Newton's method, horseshoe interpolants and rounding together.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <span>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/unit/model/linear_check.h"
#include "tests/unit/model/random_examples.h"
#include "tests/unit/model/section/exact_gradient.h"

namespace latticast::testing {
namespace {

constexpr int designs = 100;  // of each kind

/// What a state lacks to equilibrium: the exact imbalance, mapped by the inverse of the stiffness.
double true_error(const RandomExample& example, const Section& section, const State& state) {
  const Deformation q = state.deformation(section.inner_radius_mm, section.axis_rad);
  const double pressure = state.pressure_kpa / 1000;
  // By symmetry or held: no error, and perhaps no stiffness, there.
  const Held& held = example.held;
  const std::array<bool, 5> fixed = {held.stretch, held.twist || !section.twists, false,
                                     held.bend || section.bending_axes < 1,
                                     held.bend || section.bending_axes < 2};
  auto balance = full_balance(section, make_quadrature(section, 32, 24, 48), q, pressure, fixed);
  if (!balance) return std::numeric_limits<double>::infinity();
  std::array<bool, 5> wanted{};
  std::transform(fixed.begin(), fixed.end(), wanted.begin(), std::logical_not<>());
  const std::array<long double, 5> gradient = exact_gradient(section, q, pressure, wanted);
  const double outer = section.outer_radius_mm;
  const std::array<double, 5> scale = {1, 1 / outer, section.inner_radius_mm, 1 / outer, 1 / outer};
  balance->imbalance.clear();
  for (int i = 0; i < 5; ++i) {
    if (!fixed[i]) balance->imbalance.push_back(static_cast<double>(gradient[i]) * scale[i]);
  }
  return missing_step(*balance);
}

struct Comparison {
  int states = 0;
  int below = 0;                                           // estimate smaller than the error
  int far_above = 0;                                       // estimate over 1000 times the error
  double least = std::numeric_limits<double>::infinity();  // estimate / error
  double most = 0;

  void add(double estimate, double truth) {
    ++states;
    if (estimate < truth) ++below;
    if (estimate > 1000 * truth) ++far_above;
    least = std::min(least, estimate / truth);
    most = std::max(most, estimate / truth);
  }
};

Comparison compare(unsigned seed, RandomExample (*random_example)(Random&)) {
  std::printf("seed %u\n", seed);
  Random random(seed);
  Comparison comparison;
  while (comparison.states < designs) {
    const RandomExample example = random_example(random);
    const PreparedSegment prepared = prepare_segment(example.segment, example.model);
    const std::span<const double> last(&example.pressures_kpa.back(), 1);
    const Response response = predict(prepared, last, example.held);
    if (!response.states[0]) continue;
    comparison.add(response.states[0]->error_estimate,
                   true_error(example, std::get<Section>(prepared.section), *response.states[0]));
  }
  std::printf(
      "%d states: estimate below the error in %d, above 1000 times in %d; %.3g to %.3g times\n",
      comparison.states, comparison.below, comparison.far_above, comparison.least, comparison.most);
  return comparison;
}

TEST(ErrorEstimate, IsTrueOfStraightSegments) {
  const Comparison comparison = compare(20261124, random_straight_example);
  EXPECT_LE(comparison.below, designs / 100);
  EXPECT_LE(comparison.far_above, designs / 10);
}

TEST(ErrorEstimate, IsTrueOfBendingSegments) {
  const Comparison comparison = compare(20261125, random_bending_example);
  EXPECT_LE(comparison.below, designs / 100);
  EXPECT_LE(comparison.far_above, designs / 10);
}

}  // namespace
}  // namespace latticast::testing
