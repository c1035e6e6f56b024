// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/property/exact_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/mesh/point_algebra.h"
#include "tests/unit/geometry/solid/mesh_measures.h"

namespace latticast {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;  // columns first

constexpr double difference_mm = 1e-4;
constexpr int fineness = 3;

Matrix derivative(const Map& map, const Point& at) {
  Matrix columns{};
  for (int j = 0; j < 3; ++j) {
    Point low = at;
    Point high = at;
    low[j] -= difference_mm;
    high[j] += difference_mm;
    const Point from = map(low);
    const Point to = map(high);
    for (int i = 0; i < 3; ++i) columns[j][i] = (to[i] - from[i]) / (2 * difference_mm);
  }
  return columns;
}

// Rows of the inverse are cross products of the columns over the determinant.
Matrix inverse_rows(const Matrix& m) {
  Matrix rows{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const double determinant = dot(m[0], rows[0]);
  for (Point& row : rows) {
    for (double& x : row) x /= determinant;
  }
  return rows;
}

// Where the map takes to `place` from, close to `rest`.
Point before_map(const Map& map, const Point& place, Point rest) {
  for (int round = 0; round < 4; ++round) {
    const Point now = map(rest);
    const Point off{place[0] - now[0], place[1] - now[1], place[2] - now[2]};
    const Matrix rows = inverse_rows(derivative(map, rest));
    for (int i = 0; i < 3; ++i) rest[i] += dot(rows[i], off);
  }
  return rest;
}

// A level set's distance in moved space: its value over the size of its gradient there.
double moved_distance(double value, const Point& gradient, const Matrix& inverse) {
  Point moved{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) moved[i] += inverse[j][i] * gradient[j];
  }
  return std::abs(value) / std::sqrt(dot(moved, moved));
}

constexpr Matrix unmoved{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

ExactSolid::ExactSolid(double floor, double ceiling, double length, double start)
    : floor_(floor), ceiling_(ceiling), length_(length), start_(start) {}

ExactSolid ExactSolid::lattice(const Segment& segment, double start_z_mm) {
  ExactSolid solid(segment.liner_outer_radius_mm(), segment.outer_radius_mm(), segment.length_mm,
                   start_z_mm);
  solid.lattice_.emplace(segment);
  return solid;
}

ExactSolid ExactSolid::liner(const Segment& segment, double start_z_mm) {
  return {segment.inner_radius_mm(), segment.liner_outer_radius_mm(), segment.length_mm,
          start_z_mm};
}

double ExactSolid::distance_mm(const Point& place, double reach_mm) const {
  return distance_mm(place, reach_mm, {}, place);
}

double ExactSolid::distance_mm(const Point& place, double reach_mm, const Map& map,
                               const Point& rest) const {
  const Point at = map ? before_map(map, place, rest) : place;
  const Matrix inverse = map ? inverse_rows(derivative(map, at)) : unmoved;
  const double r = std::hypot(at[0], at[1]);
  const double z = at[2] - start_;
  const double drawn = 0.5 * (floor_ + ceiling_);
  Depth depth{std::min(z, length_ - z), 0, z < 0.5 * length_ ? 1.0 : -1.0};
  if (lattice_) depth = lattice_->depth(drawn * std::atan2(at[1], at[0]), z, reach_mm);
  const Point radial{at[0] / r, at[1] / r, 0};
  const double turn = depth.along_u * drawn / r;
  const Point across{-turn * radial[1], turn * radial[0], depth.along_z};
  const double wall = moved_distance(depth.mm, across, inverse);
  const double gap = std::max({floor_ - r, r - ceiling_, 0.0});
  const double to_wall = std::hypot(wall, moved_distance(gap, radial, inverse));
  if (depth.mm < 0) return to_wall;
  const double to_face = std::min(std::abs(r - floor_), std::abs(r - ceiling_));
  return std::min(to_wall, moved_distance(to_face, radial, inverse));
}

double ExactSolid::volume_mm3() const {
  const double around = 2 * std::numbers::pi;
  const double drawn = 0.5 * (floor_ + ceiling_);
  const double area = lattice_ ? lattice_->area_mm2() : around * drawn * length_;
  return area * (ceiling_ - floor_);
}

double largest_distance_mm(const TriangleMesh& mesh, const ExactSolid& exact, double reach_mm,
                           std::size_t triangles) {
  return largest_distance_mm(mesh, exact, reach_mm, triangles, {}, mesh);
}

double largest_distance_mm(const TriangleMesh& mesh, const ExactSolid& exact, double reach_mm,
                           std::size_t triangles, const Map& map, const TriangleMesh& rest) {
  const std::size_t stride = 1 + mesh.triangles.size() / triangles;
  double largest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += stride) {
    const std::vector<Point> places = points_over(mesh, mesh.triangles[t], fineness);
    const std::vector<Point> before = map ? points_over(rest, rest.triangles[t], fineness) : places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double distance = exact.distance_mm(places[i], reach_mm, map, before[i]);
      largest = std::max(largest, distance);
    }
  }
  return largest;
}

}  // namespace latticast
