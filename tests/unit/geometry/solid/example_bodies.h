// SPDX-License-Identifier: GPL-3.0-or-later
// Small closed bodies, and ways to put them together.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

inline TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({i & 1 ? 1.0 : 0, i & 2 ? 1.0 : 0, i & 4 ? 1.0 : 0});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Radii 3 and 1, around z; `around` x `across` quadrangles.
inline TriangleMesh torus(std::uint32_t around = 12, std::uint32_t across = 7) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around;
      const double b = 2 * std::numbers::pi * j / across;
      const double r = 3 + std::cos(b);
      mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
      const std::uint32_t here = i * across + j;
      const std::uint32_t up = i * across + (j + 1) % across;
      const std::uint32_t next = (i + 1) % around * across + j;
      const std::uint32_t both = (i + 1) % around * across + (j + 1) % across;
      mesh.triangles.push_back({here, next, both});
      mesh.triangles.push_back({here, both, up});
    }
  }
  return mesh;
}

inline TriangleMesh placed(TriangleMesh mesh, double scale, const Point& by) {
  for (Point& p : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = scale * p[axis] + by[axis];
  }
  return mesh;
}

inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Both bodies in one mesh, vertices not joined.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

}  // namespace latticast
