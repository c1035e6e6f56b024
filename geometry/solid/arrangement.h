// SPDX-License-Identifier: GPL-3.0-or-later
// Arrangement of strand outlines in the plane, by iterated snap rounding on an integer grid
// [Halperin 2002]: edges meet at grid points only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/drawn_edges.h"
#include "geometry/solid/plane_grid.h"

namespace latticast {

/// Patterns that are arranged together, each on a sheet of its own.
inline constexpr int most_sheets = 4;

/// The winding number that an outline of sheet `sheet` counts with. One number carries those of all
/// sheets, 16 bits for each: sums of it are sums on every sheet.
constexpr std::int64_t winding_on(int sheet) {
  return std::int64_t{1} << (16 * sheet);
}

/// The winding number of one sheet within the sum; right between -32768 and 32767.
constexpr int winding_of_sheet(std::int64_t winding, int sheet) {
  for (int below = 0; below < sheet; ++below) {
    winding = (winding - static_cast<std::int16_t>(winding & 0xFFFF)) >> 16;
  }
  return static_cast<std::int16_t>(winding & 0xFFFF);
}

/// A piece of outline inside one sector, a < b. Crossing it from its right side to its left side
/// (for an edge that runs along u: from below to above) changes the winding number by `winding`; a
/// cut line has winding 0.
struct ArrangedEdge {
  GridPoint a;
  GridPoint b;
  std::int64_t winding = 0;
  EdgeOrigin origin = on_cut;
};

/// A piece of outline on a line between two sectors.
struct LinePiece {
  std::int32_t low = 0;  ///< grid steps along z
  std::int32_t high = 0;
  EdgeOrigin origin = on_sector_line;
};

/// Sector by sector. Pieces that lie on a sector line stand apart: what is inside on either side
/// of the line follows from the sectors themselves.
struct Arrangement {
  PlaneGrid grid;
  std::vector<std::int32_t> cuts;  ///< heights of the cut lines, ascending
  std::vector<std::vector<ArrangedEdge>> sectors;
  std::vector<std::vector<LinePiece>> lines;  ///< line i is the left one of sector i; any order
  DrawnEdges drawn;                           ///< what the edges' origins count in
};

/// Rounds the patterns' outlines to the grid, cuts them at every sector line and at the heights
/// `cuts` (grid steps, ascending, inside the segment), and at each other.
///
/// Guarantees: no two edges of a sector cross or overlap; every grid point that is an end of an
/// edge lies at least one step from every other edge; a point on a sector line is known to both
/// sectors. No edge moves by more than a few grid steps. The winding of each outline is preserved.
/// Time n log n for strands of bounded crossing; throws GeometryError (geometry_error.h).
/// Precondition: one to most_sheets patterns of the grid's circumference and length.
Arrangement arrange(std::span<const Pattern> sheets, const PlaneGrid& grid,
                    std::span<const std::int32_t> cuts = {});

/// The same for a single sheet.
Arrangement arrange(const Pattern& pattern, const PlaneGrid& grid,
                    std::span<const std::int32_t> cuts = {});

}  // namespace latticast
