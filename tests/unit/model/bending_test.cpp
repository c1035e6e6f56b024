// SPDX-License-Identifier: GPL-3.0-or-later
// Sections that bend: derivatives, symmetry, known numbers.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "model/effective_rods/rods.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// The shape that was fitted to five bending angles of [Wang] (docs/bending.md#effective-rods).
Segment fitted(double thin, double thick) {
  Segment segment = columns(halves(16, thick, thin), 90, {3.5, 170, true});
  segment.liner.material.law = Linear{0.082, 0.5};
  return segment;
}

ModelChoice rods() {
  ModelChoice model;
  model.columns = ColumnModel::rods;
  return model;
}

State at(const Segment& segment, double pressure_kpa, const SolverOptions& options = {}) {
  return predict(segment, {}, std::vector<double>{pressure_kpa}, {}, options).states[0].value();
}

TEST(Rods, MeetTheFittedNumbers) {
  const auto response = predict(fitted(2, 4), rods(), std::vector<double>{20, 100});
  EXPECT_NEAR(bend_deg(*response.states[0]), 14.13, 0.02);
  EXPECT_NEAR(bend_deg(*response.states[1]), 42.87, 0.02);
  // "Large" widths are 10 mm, where the paper's plot ends; beyond, the angle still grows by 3 %.
  const auto plateau = predict(fitted(2, 10), rods(), std::vector<double>{40, 60, 80});
  EXPECT_NEAR(bend_deg(*plateau.states[0]), 30.87, 0.02);
  EXPECT_NEAR(bend_deg(*plateau.states[1]), 41.66, 0.02);
  EXPECT_NEAR(bend_deg(*plateau.states[2]), 50.03, 0.02);
}

TEST(Rods, BendTowardTheThickerHalfAndNotWhenEqual) {
  const auto thick_first = predict(fitted(2, 4), rods(), std::vector<double>{40});
  const auto thin_first = predict(fitted(4, 2), rods(), std::vector<double>{40});
  EXPECT_NEAR(thick_first.states[0]->bend_direction_rad(), pi / 2, 1e-12);
  EXPECT_NEAR(thin_first.states[0]->bend_direction_rad(), 3 * pi / 2, 1e-12);
  EXPECT_NEAR(bend_deg(*thick_first.states[0]), bend_deg(*thin_first.states[0]), 1e-10);
  const auto equal = predict(fitted(3, 3), rods(), std::vector<double>{40});
  EXPECT_LT(equal.states[0]->bend_magnitude_rad_per_mm(), 1e-15);
}

TEST(Distributed, MeetsTheUnfittedNumbers) {
  const Segment segment = columns(halves(16, 4, 2));
  const std::array<double, 4> expected = {11, 25, 40, 51};
  const auto response = predict(segment, {}, std::vector<double>{20, 40, 60, 80});
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(bend_deg(*response.states[i]), expected[i], 0.5);
}

TEST(Held, BlockedMomentOpposesTheBending) {
  const Segment segment = columns(halves(8, 4, 2));
  const auto held = predict(segment, {}, std::vector<double>{30}, {.bend = true});
  EXPECT_EQ(held.states[0]->bend_magnitude_rad_per_mm(), 0);
  const State free = at(segment, 30);
  const auto& moment = held.states[0]->moment_nmm;
  const double along = moment[0] * free.bend_rad_per_mm[0] + moment[1] * free.bend_rad_per_mm[1];
  const double size = std::hypot(moment[0], moment[1]) * free.bend_magnitude_rad_per_mm();
  EXPECT_NEAR(along / size, -1, 1e-9);
}

}  // namespace
}  // namespace latticast::testing
