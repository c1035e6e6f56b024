// SPDX-License-Identifier: GPL-3.0-or-later
// Plain measures of meshes, written apart from the audit that they help to test.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

inline Point mean(const std::vector<Point>& points) {
  Point sum{};
  for (const Point& p : points) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] += p[axis] / static_cast<double>(points.size());
  }
  return sum;
}

inline double volume_mm3(const TriangleMesh& mesh) {
  double six_times = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point& a = mesh.vertices[t[0]];
    const Point& b = mesh.vertices[t[1]];
    const Point& c = mesh.vertices[t[2]];
    six_times += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six_times / 6;
}

/// Triangles of each directed side.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_sides(
    const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  return sides;
}

/// Every directed side once, and its opposite once.
inline bool is_closed_and_oriented(const TriangleMesh& mesh) {
  const auto sides = directed_sides(mesh);
  for (const auto& [side, count] : sides) {
    const auto opposite = sides.find({side.second, side.first});
    if (count != 1 || opposite == sides.end() || opposite->second != 1) return false;
  }
  return true;
}

inline int components(const TriangleMesh& mesh) {
  DisjointSets connected(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    connected.join(t[1], t[0]);
    connected.join(t[2], t[0]);
  }
  std::set<std::uint32_t> roots;
  for (const Triangle& t : mesh.triangles) roots.insert(connected.root(t[0]));
  return static_cast<int>(roots.size());
}

/// From V - E + F = 2 components - 2 genus, for closed meshes.
inline int genus(const TriangleMesh& mesh) {
  std::set<std::uint32_t> vertices;
  for (const Triangle& t : mesh.triangles) vertices.insert(t.begin(), t.end());
  const long edges = 3 * static_cast<long>(mesh.triangles.size()) / 2;
  const long euler =
      static_cast<long>(vertices.size()) - edges + static_cast<long>(mesh.triangles.size());
  return components(mesh) - static_cast<int>(euler / 2);
}

inline double radius_of(const Point& p) {
  return std::hypot(p[0], p[1]);
}

/// Are the corners all of a radius between the two?
inline bool lies_between(const TriangleMesh& mesh, const Triangle& t, double low, double high) {
  for (const std::uint32_t v : t) {
    const double radius = radius_of(mesh.vertices[v]);
    if (radius < low || radius > high) return false;
  }
  return true;
}

/// Points spread over a triangle, its corners, its middle and its sides' middles among them.
inline std::vector<Point> points_over(const TriangleMesh& mesh, const Triangle& t, int fineness) {
  std::vector<Point> points;
  for (int i = 0; i <= fineness; ++i) {
    for (int j = 0; i + j <= fineness; ++j) {
      const double b = static_cast<double>(i) / fineness;
      const double c = static_cast<double>(j) / fineness;
      Point p{};
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = (1 - b - c) * mesh.vertices[t[0]][axis] + b * mesh.vertices[t[1]][axis] +
                  c * mesh.vertices[t[2]][axis];
      }
      points.push_back(p);
    }
  }
  return points;
}

}  // namespace latticast
