// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/relief.h"

#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/region.h"
#include "tests/unit/geometry/solid/mesh_measures.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

// Error of a regular prism with n sides whose cross-section is as large as the circle's.
double prism_error(double radius, int n) {
  const double angle = 2 * std::numbers::pi / n;
  const double corner = radius * std::sqrt(angle / std::sin(angle));
  return std::max(corner - radius, radius - corner * std::cos(0.5 * angle));
}

TEST(ChordError, IsThatOfThePrism) {
  for (const double radius : {0.1, 18.0, 1000.0}) {
    for (const int n : {3, 12, 79, 1000, 100000}) {
      EXPECT_NEAR(chord_error_mm(radius, 2 * std::numbers::pi / n), prism_error(radius, n),
                  1e-15 * radius);
    }
  }
}

TEST(ChordError, NeedsTheFewestSectors) {
  for (const double radius : {0.5, 3.0, 18.0, 250.0}) {
    int before = 0;
    for (const double tolerance : {1.0, 0.3, 0.1, 0.01, 0.001, 1e-4}) {
      SCOPED_TRACE(testing::Message() << "radius " << radius << ", tolerance " << tolerance);
      const int sectors = sectors_for(radius, tolerance);
      EXPECT_GE(sectors, 12);
      EXPECT_LE(prism_error(radius, sectors), tolerance);
      EXPECT_TRUE(sectors == 12 || prism_error(radius, sectors - 1) > tolerance);
      EXPECT_GE(sectors, before);
      EXPECT_GE(sectors_for(2 * radius, tolerance), sectors);
      before = sectors;
    }
  }
}

TEST(WallRadii, AddLevelsOnlyWhereTheToleranceNeedsThem) {
  EXPECT_EQ(wall_radii(16, 18, 0.08, 0, 1e-9), (std::vector<double>{16, 18}));
  EXPECT_EQ(wall_radii(16, 18, 0.08, 1, 0.01), (std::vector<double>{16, 18}));
  // 0.08 x 2 / 16 = 0.01 is off the surface: ten levels for 0.001.
  const std::vector<double> levels = wall_radii(16, 18, 0.08, 1, 0.001);
  ASSERT_EQ(levels.size(), 11U);
  EXPECT_EQ(levels.front(), 16);
  EXPECT_EQ(levels.back(), 18);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_NEAR(levels[i] - levels[i - 1], 0.2, 1e-12);
  }
}

Relief relief_of(const RandomPlane& plane, std::vector<double> radii, const Region& region) {
  return {triangulate(region), {std::move(radii)}, plane.pattern.length_mm / 3};
}

TEST(Wrap, OfRandomRegionsIsClosedWithTheRegionsTopologyAndVolume) {
  constexpr std::uint64_t seed = 6001;
  double worst = 0;
  for (std::uint64_t i = 0; i < 150; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const Region region = unite(plane.pattern, plane.grid, {}, 0.01);
    const double middle = plane.pattern.circumference_mm / (2 * std::numbers::pi);
    const double floor = 0.8 * middle;
    const double ceiling = 1.25 * middle;
    std::vector<double> radii{floor, ceiling};
    if (i % 2 == 1) radii.insert(radii.begin() + 1, {0.95 * middle, 1.1 * middle});
    const Relief relief = relief_of(plane, radii, region);
    const TriangleMesh mesh = wrap(relief);
    ASSERT_TRUE(is_closed_and_oriented(mesh));
    EXPECT_EQ(components(mesh), pieces(relief.plane));
    EXPECT_EQ(genus(mesh), outline_loops(region) - pieces(relief.plane));
    const double expected = area_mm2(region) * (ceiling * ceiling - floor * floor) / (2 * middle);
    ASSERT_NEAR(volume_mm3(mesh), expected, 1e-12 * expected);
    worst = std::max(worst, std::abs(volume_mm3(mesh) / expected - 1));
  }
  std::printf("seeds from %llu: largest relative volume error %.2e\n",
              static_cast<unsigned long long>(seed), worst);
}

TEST(Wrap, PutsEveryVertexAtItsPlace) {
  const RandomPlane plane = random_plane(6203);
  const Region region = unite(plane.pattern, plane.grid, {}, 0.01);
  const double middle = plane.pattern.circumference_mm / (2 * std::numbers::pi);
  const Relief relief = relief_of(plane, {0.9 * middle, middle}, region);
  const double start = relief.start_z_mm;
  const double error = chord_error_mm(middle, plane.grid.sector_angle_rad());
  for (const Point& p : wrap(relief).vertices) {
    EXPECT_GE(p[2], start - 1e-12);
    EXPECT_LE(p[2], start + plane.pattern.length_mm + 1e-9);
    EXPECT_LE(radius_of(p), middle + error);
    EXPECT_GE(radius_of(p), 0.9 * middle - error);
  }
}

TEST(Wrap, IsTheSameEveryTime) {
  const RandomPlane plane = random_plane(6301);
  const auto make = [&] {
    return wrap(relief_of(plane, {5, 6}, unite(plane.pattern, plane.grid, {}, 0.01)));
  };
  const TriangleMesh one = make();
  const TriangleMesh two = make();
  EXPECT_EQ(one.vertices, two.vertices);
  EXPECT_EQ(one.triangles, two.triangles);
}

}  // namespace
}  // namespace latticast
