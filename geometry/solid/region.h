// SPDX-License-Identifier: GPL-3.0-or-later
// The union of a pattern's strands in the unrolled plane: what is material and what is not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/plane_grid.h"

namespace latticast {

/// An edge of the region inside one column, a < b. Either its two sides differ (outline) or both
/// are inside (a cut line across the material).
struct RegionEdge {
  GridPoint a;
  GridPoint b;
  bool inside_left = false;  ///< material on the left of a -> b
  bool inside_right = false;

  bool is_outline() const { return inside_left != inside_right; }
};

/// A planar region on the periodic plane, column by column. Guarantees: edges meet at their ends
/// only; every outline vertex has exactly two outline edges (no region touches itself or another in
/// a point).
struct Region {
  PlaneGrid grid;
  std::vector<std::vector<RegionEdge>> columns;
};

/// A vertex on the line between column `line - 1` and column `line`, and whether the stretch of the
/// line from here up to the next vertex is material seen from either side.
struct LinePoint {
  std::int32_t z = 0;
  bool inside_before = false;  ///< in the column on the left of the line
  bool inside_after = false;
};

/// Unites the strands. Where material touches itself in a single point only, the point is closed
/// with a small diamond of half-width `closing_mm`, as a maker would want it and a mesh needs it.
/// Throws GeometryError (see arrangement.h).
Region unite(Pattern pattern, const PlaneGrid& grid, std::span<const std::int32_t> cuts,
             double closing_mm);

/// The vertices on a column line in ascending z, from both columns. 0 <= line < grid.columns.
std::vector<LinePoint> line_points(const Region& region, int line);

/// Area in mm^2 at the radius where the plane is unrolled; exact on the grid.
double area_mm2(const Region& region);

/// Number of closed outline curves. A region of c pieces has first Betti number loops - c, which is
/// the genus of the solid that wraps it.
int outline_loops(const Region& region);

}  // namespace latticast
