// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "design/units.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"
#include "tests/unit/geometry/solid/example_bodies.h"
#include "tests/unit/geometry/solid/example_segments.h"

namespace latticast {
namespace {

TriangleMesh box(double x, double y, double z) {
  TriangleMesh mesh = cube();
  for (Point& p : mesh.vertices) p = {x * p[0], y * p[1], z * p[2]};
  return mesh;
}

// About z, then about x.
TriangleMesh turned(TriangleMesh mesh, double first, double second) {
  for (Point& p : mesh.vertices) {
    p = {p[0] * std::cos(first) - p[1] * std::sin(first),
         p[0] * std::sin(first) + p[1] * std::cos(first), p[2]};
    p = {p[0], p[1] * std::cos(second) - p[2] * std::sin(second),
         p[1] * std::sin(second) + p[2] * std::cos(second)};
  }
  return mesh;
}

// A convex polygon, counter-clockwise, raised from z = 0.
TriangleMesh prism(const std::vector<std::array<double, 2>>& base, double height) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(base.size());
  for (const auto& p : base) {
    mesh.vertices.push_back({p[0], p[1], 0});
    mesh.vertices.push_back({p[0], p[1], height});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({2 * i, 2 * next, 2 * next + 1});
    mesh.triangles.push_back({2 * i, 2 * next + 1, 2 * i + 1});
    if (i < 2) continue;
    mesh.triangles.push_back({0, 2 * i, 2 * i - 2});
    mesh.triangles.push_back({1, 2 * i - 1, 2 * i + 1});
  }
  return mesh;
}

// `around` x `up` quadrangles, triangles at the poles.
TriangleMesh sphere(double radius, std::uint32_t around, std::uint32_t up) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, -radius}, {0, 0, radius}};
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return 2 + (j - 1) * around + i % around;
  };
  for (std::uint32_t j = 1; j < up; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double latitude = pi * j / up - pi / 2;
      const double longitude = 2 * pi * i / around;
      mesh.vertices.push_back({radius * std::cos(latitude) * std::cos(longitude),
                               radius * std::cos(latitude) * std::sin(longitude),
                               radius * std::sin(latitude)});
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(i + 1, 1), at(i, 1)});
    mesh.triangles.push_back({1, at(i, up - 1), at(i + 1, up - 1)});
    for (std::uint32_t j = 1; j + 1 < up; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

// A wedge of 40 from its tip at x = 0, or from where it is `blunt` thick.
TriangleMesh wedge(double angle_deg, double blunt = 0) {
  const double slope = std::tan(angle_deg * pi / 180);
  if (blunt == 0) return prism({{0, 0}, {40, 0}, {40, 40 * slope}}, 10);
  const double start = blunt / slope;
  return prism({{start, 0}, {40, 0}, {40, 40 * slope}, {start, blunt}}, 10);
}

TEST(WallThickness, OfPlatesIsExact) {
  const ThinWalls found = thin_walls(turned(box(0.5, 10, 10), 0.3, 1.1), 0.8);
  EXPECT_NEAR(found.least_mm, 0.5, 1e-12);
  EXPECT_NEAR(found.surface_mm2, 220, 1e-9);
  EXPECT_NEAR(found.thinner_mm2, 200, 1e-9);
}

TEST(WallThickness, IsNotBelowTheLimitAtTheLimit) {
  EXPECT_TRUE(std::isinf(thin_walls(box(0.75, 10, 10), 0.75).least_mm));
  EXPECT_EQ(thin_walls(box(0.75, 10, 10), 0.75).thinner_mm2, 0);
  EXPECT_EQ(thin_walls(box(0.75, 10, 10), 0.76).least_mm, 0.75);
  EXPECT_TRUE(std::isinf(thin_walls({}, 1).least_mm));
}

// Every pair of sides that is nearer than the limit counts, and no other.
TEST(WallThickness, OfTurnedBoxesIsTheirSmallestSide) {
  const unsigned seed = 611;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> side(0.05, 3);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for (int run = 0; run < 300; ++run) {
    const std::array<double, 3> sides = {side(random), side(random), side(random)};
    const double limit = side(random);
    const TriangleMesh mesh =
        placed(turned(box(sides[0], sides[1], sides[2]), angle(random), angle(random)), 1,
               {side(random), side(random), -50});
    const ThinWalls found = thin_walls(mesh, limit);
    double thinner = 0;
    for (int i = 0; i < 3; ++i) {
      if (sides[i] < limit) thinner += 2 * sides[(i + 1) % 3] * sides[(i + 2) % 3];
    }
    EXPECT_NEAR(found.thinner_mm2, thinner, 1e-9);
    const double least = *std::min_element(sides.begin(), sides.end());
    EXPECT_NEAR(std::min(found.least_mm, limit), std::min(least, limit), 1e-9);
  }
}

// The divisions of the two spheres do not match, so that facets are nowhere parallel.
TEST(WallThickness, OfShellsIsWithinTheirChords) {
  for (const double thickness : {0.2, 0.5, 0.7}) {
    const double radius = 8;
    const TriangleMesh shell =
        together(sphere(radius, 60, 30), turned_inside_out(sphere(radius - thickness, 47, 26)));
    ASSERT_TRUE(audit(shell).passes());
    const double chords = radius * (1 - std::pow(std::cos(pi / 47), 2));
    const ThinWalls found = thin_walls(shell, 0.8);
    EXPECT_GE(found.least_mm, thickness - chords);
    EXPECT_LE(found.least_mm, thickness + chords);
    EXPECT_GT(found.thinner_mm2, 0.9 * found.surface_mm2);
    EXPECT_NEAR(std::hypot(found.where[0], found.where[1], found.where[2]), radius - thickness / 2,
                2 * chords);
  }
}

TEST(WallThickness, OfTubesIsWithinTheTolerance) {
  Segment tube;
  tube.length_mm = 40;
  for (const double thickness : {0.3, 0.6}) {
    tube.liner = {12, thickness, {}};
    const ThinWalls found = thin_walls(liner_solid(tube, {0.02}).mesh, 0.8);
    EXPECT_NEAR(found.least_mm, thickness, 0.02);
    const double ends = 2 * pi * (std::pow(12 + thickness, 2) - 144);
    EXPECT_NEAR(found.thinner_mm2, found.surface_mm2 - ends, 0.001 * found.surface_mm2);
  }
  tube.liner = {12, 0.85, {}};
  EXPECT_TRUE(std::isinf(thin_walls(liner_solid(tube, {0.02}).mesh, 0.8).least_mm));
}

// Seen from the void's floor alone: both sides of the plate are single rectangles.
TEST(WallThickness, OverAVoidUnderALargeFace) {
  const TriangleMesh plate =
      together(box(80, 80, 5), turned_inside_out(placed(cube(), 0.5, {33.3, 41.7, 0.4})));
  const ThinWalls found = thin_walls(plate, 0.8);
  EXPECT_NEAR(found.least_mm, 0.4, 1e-12);
  EXPECT_NEAR(found.where[2], 0.2, 1e-12);
  EXPECT_NEAR(found.where[0], 33.55, 0.25);
}

TEST(WallThickness, OfWedgesDoesNotCount) {
  for (const double angle : {5.5, 8.0, 15.0, 30.0, 45.0, 60.0, 80.0}) {
    const TriangleMesh body = turned(wedge(angle), 0.7, 0.4);
    ASSERT_TRUE(audit(body).passes());
    EXPECT_TRUE(std::isinf(thin_walls(body, 0.8).least_mm)) << angle;
  }
  EXPECT_TRUE(std::isinf(thin_walls(placed(tetrahedron(), 10, {1, 2, 3}), 0.8).least_mm));
}

// Lower than float32 tells at this size, such facets may look anywhere.
TEST(WallThickness, IsNotMeasuredFromSlivers) {
  const TriangleMesh needle = placed(box(1e-5, 1e-5, 10), 1, {12, 0, 0});
  EXPECT_TRUE(std::isinf(thin_walls(together(box(10, 10, 50), needle), 0.8).least_mm));
  const TriangleMesh sheet = placed(box(1e-5, 8, 10), 1, {12, 0, 0});
  EXPECT_NEAR(thin_walls(together(box(10, 10, 50), sheet), 0.8).least_mm, 1e-5, 1e-9);
}

TEST(WallThickness, CountsWhereATaperIsLong) {
  EXPECT_LT(thin_walls(wedge(3), 0.8).least_mm, 0.1);
  for (const double angle : {2.0, 4.0, 8.0, 15.0, 19.0}) {
    const ThinWalls found = thin_walls(wedge(angle, 0.4), 0.8);
    EXPECT_GE(found.least_mm, 0.4 * std::cos(angle * pi / 180)) << angle;
    EXPECT_LE(found.least_mm, 0.4 + 0.4 * std::tan(angle * pi / 180)) << angle;
  }
}

// A strand is as wide at the radius r as docs/checks.md says. Its walls are radial, so that it is
// narrowest on the inside, and widens from there by the angle between them.
TEST(WallThickness, OfStrandsIsTheirWidthAtTheInnerRadius) {
  for (const double angle_deg : {36.0, 60.0, 90.0}) {
    const Segment segment = strips_only(angle_deg, 14, 3);
    const double s = 14 / 15.5;
    const double alpha = angle_deg * pi / 180;
    const double width = 2 * s / std::hypot(s * std::cos(alpha), std::sin(alpha));
    const TriangleMesh mesh = lattice_solid(segment, {0.005}).mesh;
    const ThinWalls found = thin_walls(mesh, 2.5);
    EXPECT_GE(found.least_mm, width - 0.01) << angle_deg;
    EXPECT_LE(found.least_mm, width + 0.5 * 2.5 * width / 14) << angle_deg;
    EXPECT_NEAR(std::hypot(found.where[0], found.where[1]), 14, 0.5 * 2.5);
    EXPECT_TRUE(std::isinf(thin_walls(mesh, 1.7).least_mm));
  }
}

}  // namespace
}  // namespace latticast
