// SPDX-License-Identifier: GPL-3.0-or-later
// Union of strands in the unrolled plane: a subdivision by winding numbers that says which layers
// are material where.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/layers.h"
#include "geometry/solid/plane_grid.h"

namespace latticast {

/// An edge of the region inside one sector, a < b. Either its two sides differ (outline) or both
/// are inside of the same layers (a cut line across the material).
struct RegionEdge {
  GridPoint a;
  GridPoint b;
  Layers inside_left = 0;  ///< layers that are material on the left of a -> b
  Layers inside_right = 0;
  EdgeOrigin origin = on_cut;

  bool is_outline() const { return inside_left != inside_right; }
};

/// A planar region on the periodic plane, sector by sector. Guarantees: edges meet at their ends
/// only; in every layer, an outline vertex has exactly two of the layer's outline edges (no region
/// touches itself or another in a point).
struct Region {
  PlaneGrid grid;
  std::vector<std::vector<RegionEdge>> sectors;
  DrawingError error{};  ///< of the patterns, and of the diamonds that close touching points
  std::vector<std::vector<LinePiece>> lines{};  ///< pieces of outlines on the sector lines
  DrawnEdges drawn{};  ///< what origins count in: outlines of the patterns and of the diamonds
};

/// A vertex on the line between sector `line - 1` and sector `line`, and whether the stretch of the
/// line from here up to the next vertex is material seen from either side.
struct LinePoint {
  std::int32_t z = 0;
  Layers inside_before = 0;  ///< in the sector on the left of the line
  Layers inside_after = 0;
};

/// Unites the strands. Where material touches itself in a single point only, the point is closed
/// with a small diamond of half-width `closing_mm`, as a maker would want it and a mesh needs it.
/// Throws GeometryError (geometry_error.h).
Region unite(Pattern pattern, const PlaneGrid& grid, std::span<const std::int32_t> cuts,
             double closing_mm);

/// The region that `filling` makes of the sheets, whose strands are united on each. Throws
/// GeometryError (geometry_error.h) also where a layer's material touches itself in a point: the
/// sheets' edges meet there, and one of them must be moved.
Region layered_region(std::span<const Pattern> sheets, const PlaneGrid& grid,
                      std::span<const std::int32_t> cuts, const Filling& filling);

/// The pattern with the diamonds that `unite` would close its touching points with. Throws as unite
/// does.
Pattern closed_pattern(Pattern pattern, const PlaneGrid& grid, double closing_mm);

/// The vertices on a sector line in ascending z, from both sectors. 0 <= line < grid.sectors.
std::vector<LinePoint> line_points(const Region& region, int line);

/// Where the stretch of a sector line between two of its points comes from, if material ends there.
EdgeOrigin origin_on_line(const Region& region, int line, std::int32_t low, std::int32_t high);

/// Area of a layer in mm^2 at the radius where the plane is unrolled; exact on the grid.
double area_mm2(const Region& region, int layer = 0);

/// How far a layer may be from what was meant: what was drawn, and what the grid did to it. Edges
/// are taken to have moved by 1.5 steps, half of one on average; ends of the segment stay.
DrawingError region_error(const Region& region, int layer = 0);

/// A closed outline of layer 0, unrolled from its first point on. Its last point is joined to the
/// first, `around_mm` further along u.
struct OutlineCurve {
  std::vector<PlanePoint> points;
  double around_mm = 0;  ///< 0, or a whole number of circumferences
};

/// All of them. Which way round they run says nothing.
std::vector<OutlineCurve> outline_curves(const Region& region);

/// Number of closed outline curves of layer 0. A region of c pieces has first Betti number loops -
/// c, which is the genus of the solid that wraps it.
int outline_loops(const Region& region);

}  // namespace latticast
