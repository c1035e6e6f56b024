// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of one sector of the plane: a constrained Delaunay triangulation between given edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/solid/layers.h"
#include "geometry/solid/plane_grid.h"

namespace latticast {

/// An edge of one sector by the numbers of its ends, and what of this sector is material beside it.
struct SectorEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Layers left = 0;  ///< layers that are material on the left of from -> to
  Layers right = 0;
};

struct SectorTriangle {
  std::array<std::uint32_t, 3> corners{};  ///< by number, counter-clockwise
  Layers layers = 0;                       ///< that are material there
};

/// Covers all that is material with triangles between the points, none of them lower than a grid
/// step where flipping edges can help it. Precondition: edges meet at their ends only, every point
/// is an end of one and lies at least a step from every other edge, and material is bounded by
/// edges on all sides.
std::vector<SectorTriangle> triangulate_sector(std::span<const GridPoint> points,
                                               std::span<const SectorEdge> edges);

}  // namespace latticast
