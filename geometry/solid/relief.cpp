// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace latticast {
namespace {

constexpr int fewest_columns = 12;
constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

double corner_factor(double column_angle) {
  return std::sqrt(column_angle / std::sin(column_angle));
}

// Makes the mesh vertices of plane vertices at radii on demand, and the faces between them.
class Wrapper {
 public:
  explicit Wrapper(const Relief& relief)
      : relief_(relief),
        grid_(relief.plane.grid),
        vertex_at_(relief.plane.vertices.size() * relief.radii_mm.size(), unused) {
    const double angle = grid_.column_angle_rad();
    for (int line = 0; line <= grid_.columns; ++line) {
      const int around = line % grid_.columns;
      directions_.push_back({std::cos(around * angle), std::sin(around * angle)});
    }
    for (const double radius : relief.radii_mm) {
      corner_radii_.push_back(radius * corner_factor(angle));
    }
  }

  TriangleMesh run() {
    const std::size_t top = corner_radii_.size() - 1;
    for (const auto& [a, b, c] : relief_.plane.triangles) {
      mesh_.triangles.push_back({vertex(a, top), vertex(b, top), vertex(c, top)});
      mesh_.triangles.push_back({vertex(a, 0), vertex(c, 0), vertex(b, 0)});
    }
    for (const auto& [from, to] : relief_.plane.outline) {
      for (std::size_t level = 0; level < top; ++level) add_wall(from, to, level);
    }
    return std::move(mesh_);
  }

 private:
  // The wall under an outline edge with the material on its left, between two neighbouring radii.
  void add_wall(std::uint32_t from, std::uint32_t to, std::size_t level) {
    const std::array<std::uint32_t, 4> corners{vertex(from, level), vertex(to, level),
                                               vertex(to, level + 1), vertex(from, level + 1)};
    if (is_flat(from, to)) {
      mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
      mesh_.triangles.push_back({corners[0], corners[2], corners[3]});
      return;
    }
    const std::uint32_t middle = add_middle(corners);
    for (int i = 0; i < 4; ++i) {
      mesh_.triangles.push_back({corners[i], corners[(i + 1) % 4], middle});
    }
  }

  // Walls along the tube lie in a plane through its axis direction, walls around it in a
  // cross-section.
  bool is_flat(std::uint32_t from, std::uint32_t to) const {
    const PlaneMeshVertex& a = relief_.plane.vertices[from];
    const PlaneMeshVertex& b = relief_.plane.vertices[to];
    return a.point.z == b.point.z || (a.column == b.column && a.point.u == b.point.u);
  }

  std::uint32_t add_middle(const std::array<std::uint32_t, 4>& corners) {
    Point middle{};
    for (const std::uint32_t corner : corners) {
      for (int axis = 0; axis < 3; ++axis) middle[axis] += 0.25 * mesh_.vertices[corner][axis];
    }
    mesh_.vertices.push_back(middle);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  std::uint32_t vertex(std::uint32_t plane_vertex, std::size_t level) {
    std::uint32_t& index = vertex_at_[plane_vertex * corner_radii_.size() + level];
    if (index == unused) {
      index = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back(
          position(relief_.plane.vertices[plane_vertex], corner_radii_[level]));
    }
    return index;
  }

  // On the chord between the column's two corner lines.
  Point position(const PlaneMeshVertex& v, double radius) const {
    const double part = static_cast<double>(v.point.u) / grid_.column_steps;
    const auto& left = directions_[v.column];
    const auto& right = directions_[v.column + 1];
    return {radius * std::lerp(left[0], right[0], part),
            radius * std::lerp(left[1], right[1], part),
            relief_.start_z_mm + v.point.z * grid_.z_step_mm};
  }

  const Relief& relief_;
  const PlaneGrid& grid_;
  std::vector<std::array<double, 2>>
      directions_;  // of the column lines; the last is the first again
  std::vector<double> corner_radii_;
  std::vector<std::uint32_t> vertex_at_;  // mesh vertex of (plane vertex, level)
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh wrap(const Relief& relief) {
  return Wrapper(relief).run();
}

double chord_error_mm(double radius_mm, double column_angle_rad) {
  const double factor = corner_factor(column_angle_rad);
  return radius_mm * std::max(factor - 1, 1 - factor * std::cos(0.5 * column_angle_rad));
}

int columns_for(double radius_mm, double tolerance_mm) {
  // factor - 1 = D^2/12 + O(D^4), so this first guess is at most a few columns off.
  const double angle = std::sqrt(12 * tolerance_mm / radius_mm);
  int columns = std::max(fewest_columns, static_cast<int>(2 * std::numbers::pi / angle));
  while (chord_error_mm(radius_mm, 2 * std::numbers::pi / columns) > tolerance_mm) ++columns;
  return columns;
}

std::vector<double> wall_radii(double floor_mm, double ceiling_mm, double column_angle_rad,
                               double steepness, double tolerance_mm) {
  // A wall's middle vertex leaves the ruled surface by 1/16 of the difference between its outer and
  // inner edge, which is the column's angle times the wall's depth; square to the wall, times
  // steepness.
  const double depth = ceiling_mm - floor_mm;
  const double off = column_angle_rad * depth * steepness / 16;
  const int layers = std::max(1, static_cast<int>(std::ceil(off / tolerance_mm - 1e-9)));
  std::vector<double> radii(layers + 1);
  for (int i = 0; i <= layers; ++i) radii[i] = std::lerp(floor_mm, ceiling_mm, double(i) / layers);
  return radii;
}

}  // namespace latticast
