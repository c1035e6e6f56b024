// SPDX-License-Identifier: GPL-3.0-or-later
// Preview meshes against the surfaces that they stand for: every triangle's points, moved with its
// corners, lie within the tolerance of the exactly moved floor, ceiling or wall.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh/point_algebra.h"
#include "model/shape/shape.h"
#include "report/preview.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/mesh_measures.h"

namespace latticast {
namespace {

using Surface = std::function<Point(double, double)>;

// From a point to the surface, by Gauss and Newton from a place (a, b) close to the foot.
double distance(const Point& from, const Surface& surface, double a, double b) {
  for (int round = 0; round < 4; ++round) {
    constexpr double h = 1e-5;
    const Point off = difference(from, surface(a, b));
    const Point along_a = difference(surface(a + h, b), surface(a - h, b));
    const Point along_b = difference(surface(a, b + h), surface(a, b - h));
    const double aa = dot(along_a, along_a);
    const double ab = dot(along_a, along_b);
    const double bb = dot(along_b, along_b);
    const double fa = dot(along_a, off);
    const double fb = dot(along_b, off);
    const double determinant = aa * bb - ab * ab;
    a += 2 * h * (fa * bb - fb * ab) / determinant;
    b += 2 * h * (fb * aa - fa * ab) / determinant;
  }
  const Point off = difference(from, surface(a, b));
  return std::sqrt(dot(off, off));
}

struct Deformed {
  const char* name;
  double stretch, twist, kappa_1, kappa_2, turn, inner_radius;
};

constexpr Deformed shapes[] = {{"twisted", 1.2, 0.03, 0, 0, 0, 14},
                               {"bent", 1.2, 0, 0.01, 0, 0, 12.5},
                               {"bent sharply", 1.4, 0, -0.02, 0.02, 0, 13},
                               {"bent and twisted", 1.2, 0.02, 0.008, 0.004, 0, 13},
                               {"helical", 1.2, 0.01, 0.006, 0.002, 0.034, 14},
                               {"helical, unwound", 1.2, -0.034, 0.006, 0, 0.034, 14},
                               {"widened", 1.3, 0, 0, 0, 0, 18}};

Design design_of(double angle_deg, double tolerance) {
  Design design;
  design.segments = {strips_only(angle_deg, 16, 2)};
  design.segments[0].length_mm = 85;
  design.segments[0].liner = {12, 4, {}};
  design.output.tolerance_mm = tolerance;
  return design;
}

PreviewShape moved_by(const Deformed& by, const Segment& segment) {
  State state;
  state.stretch = by.stretch;
  state.twist_rad_per_mm = by.twist;
  state.bend_rad_per_mm = {by.kappa_1, by.kappa_2};
  state.frame_turn_rad_per_mm = by.turn;
  state.inner_radius_mm = by.inner_radius;
  const double outer = segment.outer_radius_mm();
  const double inner = segment.inner_radius_mm();
  state.outer_radius_mm =
      std::sqrt(by.inner_radius * by.inner_radius + (outer * outer - inner * inner) / by.stretch);
  const std::vector<State> states{state};
  return {"", "", Shape(std::vector<Segment>{segment}, states), states};
}

struct Errors {
  double faces = 0;
  double walls = 0;
};

class Comparison {
 public:
  Comparison(const Design& design, const PreviewShape& at)
      : segment_(design.segments[0]),
        shape_(at.shape),
        options_(preview_options(design, 0, 0, {at})) {}

  Errors of_lattice() {
    return errors(lattice_solid(segment_, options_).mesh, 16, segment_.outer_radius_mm());
  }
  Errors of_liner() { return errors(liner_solid(segment_, options_).mesh, 12, 16); }
  std::size_t triangles = 0;

 private:
  Point moved(double radius, double turn, double z) const {
    return shape_.moved({radius * std::cos(turn), radius * std::sin(turn), z}, 0);
  }

  double face_error(double radius, const Point& rest, const Point& point) const {
    const Surface face = [&](double turn, double z) { return moved(radius, turn, z); };
    return distance(point, face, std::atan2(rest[1], rest[0]), rest[2]);
  }

  // The side of a strip is drawn straight along u = start + z cot(angle).
  double wall_error(const Point& rest, const Point& point) const {
    const Grid& grid = segment_.lattice->grids[0];
    const double middle = segment_.lattice_mid_radius_mm();
    const double slope = grid.angle_deg == 90 ? 0 : 1 / std::tan(grid.angle_rad()) / middle;
    const double half = 0.5 * grid.widths_mm[0] / std::sin(grid.angle_rad()) / middle;
    const double turn = std::atan2(rest[1], rest[0]) - slope * rest[2];
    double nearest = HUGE_VAL;
    for (int i = 0; i < grid.count(); ++i) {
      for (const double side : {-half, half}) {
        const double start = i * 2 * std::numbers::pi / grid.count() + side;
        if (std::abs(std::remainder(turn - start, 2 * std::numbers::pi)) > half) continue;
        const Surface wall = [&](double radius, double z) {
          return moved(radius, start + slope * z, z);
        };
        nearest = std::min(nearest, distance(point, wall, radius_of(rest), rest[2]));
      }
    }
    return nearest;
  }

  Errors errors(const TriangleMesh& rest, double floor, double ceiling) {
    const TriangleMesh mesh = moved_mesh(rest, shape_, 0);
    triangles = rest.triangles.size();
    Errors worst;
    // Enough triangles of a large mesh, spread over it.
    const std::size_t stride = 1 + rest.triangles.size() / 1000;
    for (std::size_t i = 0; i < rest.triangles.size(); i += stride) {
      const Triangle& t = rest.triangles[i];
      const bool low = lies_between(rest, t, 0, floor + 0.1);
      const bool high = lies_between(rest, t, ceiling - 0.1, 1e9);
      const double z = rest.vertices[t[0]][2];
      const bool end =
          (z == 0 || z == 85) && rest.vertices[t[1]][2] == z && rest.vertices[t[2]][2] == z;
      if (end) continue;
      const std::vector<Point> from = points_over(rest, t, 4);
      const std::vector<Point> to = points_over(mesh, t, 4);
      for (std::size_t k = 0; k < from.size(); ++k) {
        if (low || high) {
          worst.faces = std::max(worst.faces, face_error(low ? floor : ceiling, from[k], to[k]));
        } else {
          worst.walls = std::max(worst.walls, wall_error(from[k], to[k]));
        }
      }
    }
    return worst;
  }

  const Segment& segment_;
  const Shape& shape_;
  SolidOptions options_;
};

void expect_within_tolerance(const Deformed& by, double angle, double thickness, double tolerance) {
  Design design = design_of(angle, tolerance);
  design.segments[0].lattice->thickness_mm = thickness;
  const PreviewShape at = moved_by(by, design.segments[0]);
  Comparison comparison(design, at);
  const Errors lattice = comparison.of_lattice();
  const std::size_t lattice_triangles = comparison.triangles;
  const Errors liner = comparison.of_liner();
  SCOPED_TRACE(testing::Message() << by.name << ", angle " << angle << ", thickness " << thickness
                                  << ", tolerance " << tolerance);
  EXPECT_LE(lattice.faces, tolerance);
  EXPECT_LE(lattice.walls, tolerance);
  EXPECT_LE(liner.faces, tolerance);
  EXPECT_GT(lattice.walls + lattice.faces, 0);
  std::printf(
      "%s, %g degrees, %g thick, %g: faces %.2f, walls %.2f, liner %.2f of it; %zu and %zu\n",
      by.name, angle, thickness, tolerance, lattice.faces / tolerance, lattice.walls / tolerance,
      liner.faces / tolerance, lattice_triangles, comparison.triangles);
}

TEST(MovedSolid, StaysWithinTheToleranceOfTheMovedSurfaces) {
  for (const Deformed& by : shapes) {
    for (const double angle : {90.0, 36.0, 120.0}) expect_within_tolerance(by, angle, 2, 0.02);
  }
}

TEST(MovedSolid, StaysWithinTheToleranceWhereLayersAreThick) {
  for (const double angle : {90.0, 36.0}) {
    for (const Deformed& by : shapes) expect_within_tolerance(by, angle, 8, 0.02);
    expect_within_tolerance(shapes[0], angle, 2, 0.002);
  }
}

}  // namespace
}  // namespace latticast
