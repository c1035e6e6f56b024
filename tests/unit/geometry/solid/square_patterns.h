// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns and regions drawn by hand, in grid steps: four sectors of 1024 x 1024 steps.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "geometry/solid/region.h"

namespace latticast {

/// Corners in steps from the seam, over as many sectors as needed; counter-clockwise.
using StepOutline = std::vector<GridPoint>;

inline PlaneGrid square_grid() {
  return {4, 1 << 10, 1 << 10, 1e-2, 1e-2};
}

inline Pattern on_square_grid(const std::vector<StepOutline>& outlines) {
  const PlaneGrid grid = square_grid();
  Pattern pattern{
      grid.sectors * grid.sector_steps * grid.u_step_mm, grid.length_steps * grid.z_step_mm, {}};
  for (const StepOutline& outline : outlines) {
    Strand strand;
    for (const GridPoint p : outline) {
      strand.outline.push_back({p.u * grid.u_step_mm, p.z * grid.z_step_mm});
    }
    pattern.strands.push_back(strand);
  }
  return pattern;
}

inline StepOutline rectangle(std::int32_t u, std::int32_t z, std::int32_t width,
                             std::int32_t height) {
  return {{u, z}, {u + width, z}, {u + width, z + height}, {u, z + height}};
}

/// A vertex named once: sector of the line on its left, steps from there, height.
using NamedVertex = std::pair<int, GridPoint>;

inline NamedVertex named(const PlaneGrid& grid, int sector, GridPoint point) {
  if (point.u == grid.sector_steps) return {(sector + 1) % grid.sectors, {0, point.z}};
  return {sector, point};
}

/// Every outline edge's two ends; those along sector lines come from line_points.
inline std::vector<std::pair<NamedVertex, NamedVertex>> outline_edges(const Region& region) {
  std::vector<std::pair<NamedVertex, NamedVertex>> edges;
  for (int c = 0; c < region.grid.sectors; ++c) {
    for (const RegionEdge& edge : region.sectors[c]) {
      if (!edge.is_outline()) continue;
      edges.emplace_back(named(region.grid, c, edge.a), named(region.grid, c, edge.b));
    }
    const std::vector<LinePoint> points = line_points(region, c);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].inside_before == points[i].inside_after) continue;
      edges.push_back({{c, {0, points[i].z}}, {c, {0, points[i + 1].z}}});
    }
  }
  return edges;
}

}  // namespace latticast
