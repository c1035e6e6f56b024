// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a planar domain for finite elements: constrained Delaunay refinement ([Shewchuk
// 2002], by CGAL).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pattern/plane_point.h"

namespace latticast {

struct RefinedTriangles {
  std::vector<PlanePoint> points;                       ///< those given, then new ones
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise
  /// What each edge given was split into, from its first end to its last.
  std::vector<std::vector<std::uint32_t>> edges;
};

/// Covers what the edges enclose with triangles whose sides are at most `size_mm` long and whose
/// angles are at least 20 degrees where the angles between edges allow it. Edges may be split; the
/// same for every run. Precondition: edges meet at their ends only, and the outermost form a loop.
RefinedTriangles refined_triangles(std::span<const PlanePoint> points,
                                   std::span<const std::array<std::uint32_t, 2>> edges,
                                   double size_mm);

}  // namespace latticast
