// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting of outlines: their edges are rounded to the plane's grid, cut at sector lines and at
// heights, and filed under the sectors and lines that they lie in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/solid/arrangement.h"

namespace latticast {

using LinePieces = std::vector<LinePiece>;

/// How a piece of outline counts, and what it comes from.
struct PieceSource {
  std::int64_t winding = 0;
  EdgeOrigin origin = on_cut;
};

/// The edge between two points, a < b, with the winding of a piece that runs from `from` to `to`.
ArrangedEdge ordered(GridPoint from, GridPoint to, PieceSource source);

/// Does the edge lie on a line between two sectors?
bool lies_on_line(const ArrangedEdge& edge, std::int32_t sector_steps);

LinePiece piece_of_line(std::int64_t from_z, std::int64_t to_z, EdgeOrigin origin);

class OutlineCutter {
 public:
  /// Adds to the arrangement's sectors and lines; it and the cuts must outlive the cutter.
  OutlineCutter(std::span<const std::int32_t> cuts, Arrangement& plane);

  /// Adds an outline's pieces. Its edges' origins count on from `first`; those along an end of the
  /// segment get the end's.
  void add_outline(const std::vector<PlanePoint>& outline, std::int64_t winding, EdgeOrigin first);

 private:
  // A grid point before the plane is made periodic.
  struct FarPoint {
    std::int64_t u = 0;
    std::int64_t z = 0;
  };

  FarPoint to_grid(PlanePoint point) const;
  EdgeOrigin origin_of(FarPoint from, FarPoint to, EdgeOrigin drawn) const;
  void add_edge(FarPoint a, FarPoint b, PieceSource source);
  void add_piece(FarPoint a, FarPoint b, PieceSource source);
  void add_part(std::size_t sector, GridPoint from, GridPoint to, PieceSource source);
  std::size_t around(std::int64_t i) const;
  std::vector<std::int32_t> heights_between(std::int32_t from, std::int32_t to) const;

  const PlaneGrid& grid_;
  std::span<const std::int32_t> cuts_;
  Arrangement& plane_;
};

}  // namespace latticast
