// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/segment_response.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

TEST(Response, RestIsExact) {
  const Response response = predict(paper_segment({36}), {}, std::vector<double>{0});
  const State& state = response.states[0].value();
  EXPECT_EQ(state.stretch, 1);
  EXPECT_EQ(state.twist_rad_per_mm, 0);
  EXPECT_EQ(state.inner_radius_mm, 12);
  EXPECT_EQ(state.outer_radius_mm, 18);
  EXPECT_EQ(state.residual, 0);
  EXPECT_EQ(state.error_estimate, 0);
  EXPECT_TRUE(state.stable);
}

TEST(Response, AnswersComeInTheOrderAsked) {
  const std::vector<double> asked = {40, 0, -15, 40, 5, -30, 60, 5, -0.0};
  const Response response = predict(paper_segment({36}), {}, asked);
  ASSERT_EQ(response.status, Status::ok);
  ASSERT_EQ(response.states.size(), asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(response.states[i]->pressure_kpa, asked[i]);
    const Response alone = predict(paper_segment({36}), {}, std::vector<double>{asked[i]});
    EXPECT_NEAR(response.states[i]->stretch, alone.states[0]->stretch, 1e-11);
    EXPECT_NEAR(response.states[i]->twist_rad_per_mm, alone.states[0]->twist_rad_per_mm, 1e-12);
    EXPECT_NEAR(response.states[i]->inner_radius_mm, alone.states[0]->inner_radius_mm, 1e-10);
  }
  EXPECT_EQ(response.states[0]->stretch, response.states[3]->stretch);
  EXPECT_LT(response.states[2]->inner_radius_mm, 12);
}

TEST(Response, NothingAskedNothingAnswered) {
  const Response response = predict(paper_segment({36}), {}, {});
  EXPECT_TRUE(response.states.empty());
  EXPECT_EQ(response.status, Status::ok);
}

TEST(Response, PressuresMustBeNumbers) {
  const std::vector<double> bad = {10, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(predict(paper_segment({36}), {}, bad), std::invalid_argument);
  const std::vector<double> endless = {std::numeric_limits<double>::infinity()};
  EXPECT_THROW(predict(paper_segment({36}), {}, endless), std::invalid_argument);
}

TEST(Response, BothEndsOfTheBranchAreReported) {
  const Response response =
      predict(tube(14, 18, NeoHookean{0.08}), {}, std::vector<double>{30, -10, 10, -30});
  EXPECT_EQ(response.status, Status::no_equilibrium);
  EXPECT_FALSE(response.states[0]);
  EXPECT_TRUE(response.states[1]);
  EXPECT_TRUE(response.states[2]);
  EXPECT_TRUE(response.states[3]);
  EXPECT_LT(response.states[3]->inner_radius_mm, response.states[1]->inner_radius_mm);
}

TEST(Response, StateRepeatsItsDeformation) {
  const State state = *predict(paper_segment({36}), {}, std::vector<double>{30}).states[0];
  const Deformation q = state.deformation(12);
  EXPECT_EQ(q.twist, state.twist_rad_per_mm);
  EXPECT_NEAR(current_radius_mm(12, 18, q), state.outer_radius_mm, 1e-12);
  // The wall keeps its volume.
  const double area =
      state.outer_radius_mm * state.outer_radius_mm - state.inner_radius_mm * state.inner_radius_mm;
  EXPECT_NEAR(area * state.stretch, 18 * 18 - 12 * 12, 1e-10);
}

TEST(PreparedSegments, PrepareEqualSegmentsOnce) {
  PreparedSegments segments({});
  const Segment one = paper_segment({36});
  const PreparedSegment& first = segments.prepare(one);
  Segment other = one;
  other.lattice->grids[0].widths_mm[3] = 2.5;
  EXPECT_NE(&segments.prepare(other), &first);
  Segment longer = one;
  longer.length_mm = 90;
  EXPECT_EQ(segments.prepare(longer).length_mm, 90);
  EXPECT_EQ(&segments.prepare(paper_segment({36})), &first);
}

}  // namespace
}  // namespace latticast::testing
