// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes made for tests.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

inline TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 0.1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// A closed torus, major radius 17 mm, minor radius 1 mm, facing outward, with coordinates that
/// float32 rounds.
inline TriangleMesh torus(std::uint32_t around, std::uint32_t across) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / across;
      const double r = 17 + std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return i % around * across + j % across;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace latticast
