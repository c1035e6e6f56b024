// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tip_force.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

Segment bending(double thick) {
  Segment segment = paper_segment({});
  std::vector<double> widths(16, 2);
  for (int j = 0; j < 8; ++j) widths[j] = thick;
  segment.lattice->grids.push_back({90, widths, Horseshoe{85.0 / 32, 180, true}});
  return segment;
}

TEST(TipForce, WeakBendingFollowsLinearTheory) {
  // With kappa = kappa_0 + M/EI and x(L) = 0: F = 3 EI kappa_0/(2 L). EI from blocked moment.
  const PreparedSegment prepared = prepare_segment(bending(3), {});
  const std::vector<double> pressure = {0.05};
  const State free = *predict(prepared, pressure).states[0];
  const State held = *predict(prepared, pressure, {.bend = true}).states[0];
  const double moment = std::hypot(held.moment_nmm[0], held.moment_nmm[1]);
  const auto found = blocked_tip_force(prepared, pressure[0]);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->force_n / (1.5 * moment / 85), 1, 1e-3);
  EXPECT_NEAR(found->tip_turn_rad / (0.25 * free.bend_magnitude_rad_per_mm() * 85), 1, 1e-3);
  EXPECT_NEAR(found->base_moment_nmm, found->force_n * found->tip_height_mm, 1e-12);
}

TEST(TipForce, GrowsWithTheWidthRatioAndPressure) {
  double before = 0;
  for (const double thick : {2.0, 2.5, 3.0, 3.5}) {
    const PreparedSegment prepared = prepare_segment(bending(thick), {});
    const auto found = blocked_tip_force(prepared, 30);
    ASSERT_TRUE(found);
    std::printf("2:%g at 30 kPa: %.4f N\n", thick, found->force_n);
    if (thick == 2) {
      EXPECT_EQ(found->force_n, 0);
      continue;
    }
    EXPECT_GT(found->force_n, before);
    before = found->force_n;
    EXPECT_LT(blocked_tip_force(prepared, 15)->force_n, found->force_n);
  }
}

TEST(TipForce, NonPlanarSectionsAreRefused) {
  Segment tilted = bending(3);
  tilted.lattice->grids[0].angle_deg = 60;
  EXPECT_THROW(blocked_tip_force(prepare_segment(tilted, {}), 10), UnsupportedDesign);
}

}  // namespace
}  // namespace latticast::testing
