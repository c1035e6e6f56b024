// SPDX-License-Identifier: GPL-3.0-or-later
// When two meshes are the same at float32.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

inline std::uint32_t bits(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

/// Corner by corner and bit by bit at float32, whatever the vertices' numbering; NaN equals NaN.
inline void expect_same_corners(const TriangleMesh& a, const TriangleMesh& b) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = a.vertices.at(a.triangles[i][corner])[axis];
        const double y = b.vertices.at(b.triangles[i][corner])[axis];
        if (std::isnan(x) && std::isnan(y)) {
          continue;
        }
        ASSERT_EQ(bits(x), bits(y))
            << "triangle " << i << " corner " << corner << ": " << x << " and " << y;
      }
    }
  }
}

/// As above, and numbered alike, vertices that no triangle uses included.
inline void expect_same_mesh(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.triangles, b.triangles);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = a.vertices[i][axis];
      const double y = b.vertices[i][axis];
      ASSERT_TRUE(bits(x) == bits(y) || (std::isnan(x) && std::isnan(y)))
          << "vertex " << i << ": " << x << " and " << y;
    }
  }
}

}  // namespace latticast
