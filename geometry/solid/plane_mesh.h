// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation of a planar region, constrained Delaunay (CGAL); no triangle reaches across a
// sector line or a cut height.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/solid/region.h"

namespace latticast {

struct PlaneMeshVertex {
  int sector = 0;  ///< a vertex on a line belongs to the sector on the line's right, with u = 0
  GridPoint point;
};

/// An edge between different layers, or between material and none.
struct OutlineEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Layers left = 0;  ///< layers that are material on the left of from -> to; never none
  Layers right = 0;
  EdgeOrigin origin = on_sector_line;

  bool operator==(const OutlineEdge&) const = default;
};

/// Triangles are counter-clockwise seen from outside the tube. Outline edges run with material on
/// their left; those of each layer close into loops. Vertices are ordered by line, then by sector:
/// the same for every run and machine.
struct PlaneMesh {
  PlaneGrid grid;
  std::vector<PlaneMeshVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Layers> layers;  ///< of each triangle
  std::vector<OutlineEdge> outline;
  DrawnEdges drawn;  ///< what the outline's origins count in
};

/// Triangulates the inside of a region; constrained Delaunay, sector by sector (CGAL), with some
/// diagonals flipped where a triangle would be lower than a grid step. Uses exactly the region's
/// vertices. Time n log n.
PlaneMesh triangulate(const Region& region);

/// Number of connected pieces of the triangulated region.
int pieces(const PlaneMesh& mesh);

}  // namespace latticast
