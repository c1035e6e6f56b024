// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes made for tests.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

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

/// Coordinates from all float32 bit patterns: tiny, huge, infinite, NaN and both zeros.
inline TriangleMesh any_floats(unsigned seed) {
  std::mt19937 random(seed);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    Point point;
    for (double& x : point) {
      x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    }
    mesh.vertices.push_back(point);
    if (i % 3 == 2) {
      mesh.triangles.push_back({i - 2, i - 1, i});
    }
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  mesh.vertices[0] = {-0.0, 0.0, infinity};
  mesh.vertices[1] = {-infinity, std::numeric_limits<double>::quiet_NaN(), 1e300};
  mesh.vertices[2] = {1.17549435e-38, 1e-45, 3.4028235e38};
  return mesh;
}

/// What meshes should not be and files must hold all the same: an edge with three faces, a vertex
/// that joins two fans, repeated and unused vertices, tiny and huge coordinates, minus zero.
inline TriangleMesh hard_mesh() {
  return {{{-0.0, 0, 0},
           {1, 0, 0},
           {0, 1, 0},
           {0, 0, 1},
           {0, 0, -1},
           {1, 0, 0},
           {7, 8, 9},
           {1e-30, -1e-30, 1e30},
           {-1e30, 0.1, 1.0 / 3},
           {16777217, 85, -0.0}},
          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 7, 8}, {8, 9, 5}, {9, 1, 0}}};
}

}  // namespace latticast
