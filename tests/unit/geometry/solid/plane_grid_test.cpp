// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_grid.h"

#include <bit>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace latticast {
namespace {

TEST(PlaneGrid, StepsFillTheSectorsAndTheLengthExactly) {
  for (const double circumference : {0.01, 1.0, 106.8, 5000.0, 6e5}) {
    for (const int sectors : {3, 12, 79, 5000}) {
      SCOPED_TRACE(testing::Message() << circumference << " mm, " << sectors << " sectors");
      const PlaneGrid grid = make_plane_grid(circumference, 85, sectors);
      EXPECT_TRUE(std::has_single_bit(static_cast<std::uint32_t>(grid.sector_steps)));
      EXPECT_NEAR(grid.u_step_mm * grid.sector_steps * sectors, circumference,
                  1e-12 * circumference);
      EXPECT_NEAR(grid.z_step_mm * grid.length_steps, 85, 1e-12 * 85);
      EXPECT_DOUBLE_EQ(grid.sector_angle_rad(), 2 * std::numbers::pi / sectors);
    }
  }
}

TEST(PlaneGrid, StepsAreAsFineAsAskedWhereFloat32Allows) {
  const PlaneGrid grid = make_plane_grid(100, 80, 80, 1e-3);
  EXPECT_LE(grid.u_step_mm, 1e-3 * 1.5);  // a power of two at the nearest or above
  EXPECT_NEAR(grid.z_step_mm, 1e-3, 1e-6);
}

TEST(PlaneGrid, StepsStayApartInFloat32) {
  for (const double length : {1.0, 85.0, 1000.0, 1e5}) {
    const PlaneGrid grid = make_plane_grid(100, length, 80);
    const auto end = static_cast<float>(length);
    EXPECT_GT(grid.z_step_mm, end - std::nextafter(end, 0.0F)) << length;
  }
}

TEST(PlaneGrid, TurnIsExactForTheLargestCoordinates) {
  constexpr std::int32_t far = 1 << 30;
  EXPECT_EQ(turn({0, 0}, {far, far}, {far, far - 1}), -std::int64_t{far});
  EXPECT_EQ(turn({0, 0}, {far, far - 1}, {far - 1, far - 2}), -1);
  EXPECT_EQ(turn({0, 0}, {far, far - 1}, {far, far - 1}), 0);
}

}  // namespace
}  // namespace latticast
