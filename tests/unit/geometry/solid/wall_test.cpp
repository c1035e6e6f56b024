// SPDX-License-Identifier: GPL-3.0-or-later
// The walls of tilted strips against the surface that they stand for: radial lines along the
// strip's side, a helicoid.
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/tube_solids.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/mesh_measures.h"

namespace latticast {
namespace {

struct Strips {
  double angle_rad;
  double middle_radius;
  double half_width_along_u;
  int count;
};

Strips strips_of(const Segment& segment) {
  const Grid& grid = segment.lattice->grids[0];
  const double angle = grid.angle_deg * std::numbers::pi / 180;
  return {angle, segment.lattice_mid_radius_mm(), 0.5 * grid.widths_mm[0] / std::sin(angle),
          grid.count()};
}

// Distance from a point to the nearest side's helicoid, to first order in itself: the turn to the
// side at the point's height, as an arc, times the sine of the side's slope at the point's radius.
double distance_to_sides(const Strips& strips, const Point& p) {
  const double turn = std::atan2(p[1], p[0]);
  const double radius = radius_of(p);
  const double slope = std::atan2(strips.middle_radius * std::sin(strips.angle_rad),
                                  radius * std::cos(strips.angle_rad));
  double nearest = HUGE_VAL;
  for (int i = 0; i < strips.count; ++i) {
    for (const int side : {-1, 1}) {
      const double u = i * 2 * std::numbers::pi * strips.middle_radius / strips.count +
                       side * strips.half_width_along_u + p[2] / std::tan(strips.angle_rad);
      const double off = std::remainder(turn - u / strips.middle_radius, 2 * std::numbers::pi);
      nearest = std::min(nearest, radius * std::abs(off) * std::abs(std::sin(slope)));
    }
  }
  return nearest;
}

void expect_walls_near_helicoids(const Segment& segment, double tolerance) {
  SolidOptions options;
  options.tolerance_mm = tolerance;
  const Solid solid = lattice_solid(segment, options);
  const Strips strips = strips_of(segment);
  const double middle = strips.middle_radius;
  int walls = 0;
  double worst = 0;
  for (const Triangle& t : solid.mesh.triangles) {
    const bool floor = lies_between(solid.mesh, t, 0, segment.liner_outer_radius_mm() + tolerance);
    const bool ceiling = lies_between(solid.mesh, t, segment.outer_radius_mm() - tolerance, 1e9);
    const bool end = lies_between(solid.mesh, t, 0, 1e9) &&
                     solid.mesh.vertices[t[0]][2] == solid.mesh.vertices[t[1]][2] &&
                     solid.mesh.vertices[t[1]][2] == solid.mesh.vertices[t[2]][2];
    if (floor || ceiling || end) continue;
    ++walls;
    for (const Point& p : points_over(solid.mesh, t, 8)) {
      worst = std::max(worst, distance_to_sides(strips, p));
    }
  }
  EXPECT_GE(walls, 24);
  EXPECT_LE(worst, tolerance + 1e-4)
      << "thickness " << segment.lattice->thickness_mm << " at " << middle;
}

TEST(Walls, StayWithinTheToleranceOfTheHelicoids) {
  for (const double angle : {10.0, 36.0, 60.0, 85.0, 89.0, 95.0, 144.0}) {
    for (const double tolerance : {0.1, 0.01, 0.001}) {
      SCOPED_TRACE(testing::Message() << angle << " degrees, tolerance " << tolerance);
      expect_walls_near_helicoids(strips_only(angle, 16, 2), tolerance);
    }
  }
}

TEST(Walls, OfThickLayersStayWithinTheTolerance) {
  for (const double angle : {36.0, 85.0}) {
    for (const double tolerance : {0.1, 0.01, 0.002}) {
      SCOPED_TRACE(testing::Message() << angle << " degrees, tolerance " << tolerance);
      expect_walls_near_helicoids(strips_only(angle, 4, 16), tolerance);
    }
  }
}

TEST(Walls, OfAxialColumnsAreFlatAndRadial) {
  SolidOptions options;
  options.tolerance_mm = 0.001;
  const Segment segment = strips_only(90, 4, 16);
  const Solid solid = lattice_solid(segment, options);
  // Two levels only, however fine the tolerance.
  for (const Point& p : solid.mesh.vertices) {
    const double radius = radius_of(p);
    EXPECT_TRUE(std::abs(radius - 4) <= 0.001 || std::abs(radius - 20) <= 0.001) << radius;
  }
}

}  // namespace
}  // namespace latticast
