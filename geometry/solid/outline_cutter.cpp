// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/outline_cutter.h"

#include <algorithm>
#include <cmath>

namespace latticast {

ArrangedEdge ordered(GridPoint from, GridPoint to, PieceSource source) {
  return from < to ? ArrangedEdge{from, to, source.winding, source.origin}
                   : ArrangedEdge{to, from, -source.winding, source.origin};
}

bool lies_on_line(const ArrangedEdge& edge, std::int32_t sector_steps) {
  return edge.a.u == edge.b.u && (edge.a.u == 0 || edge.a.u == sector_steps);
}

LinePiece piece_of_line(std::int64_t from_z, std::int64_t to_z, EdgeOrigin origin) {
  const auto [low, high] =
      std::minmax({static_cast<std::int32_t>(from_z), static_cast<std::int32_t>(to_z)});
  return {low, high, origin};
}

OutlineCutter::OutlineCutter(std::span<const std::int32_t> cuts, Arrangement& plane)
    : grid_(plane.grid), cuts_(cuts), plane_(plane) {}

OutlineCutter::FarPoint OutlineCutter::to_grid(PlanePoint point) const {
  return {std::llround(point.u / grid_.u_step_mm),
          std::clamp<std::int64_t>(std::llround(point.z / grid_.z_step_mm), 0, grid_.length_steps)};
}

void OutlineCutter::add_outline(const std::vector<PlanePoint>& outline, std::int64_t winding,
                                EdgeOrigin first) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FarPoint from = to_grid(outline[i]);
    const FarPoint to = to_grid(outline[(i + 1) % outline.size()]);
    // Cut points are computed from the lower-left end, so that two outlines sharing an edge in
    // opposite directions share its cut points as well.
    const bool forward = from.u < to.u || (from.u == to.u && from.z < to.z);
    const EdgeOrigin origin = origin_of(from, to, first + static_cast<EdgeOrigin>(i));
    add_edge(forward ? from : to, forward ? to : from, {forward ? winding : -winding, origin});
  }
}

EdgeOrigin OutlineCutter::origin_of(FarPoint from, FarPoint to, EdgeOrigin drawn) const {
  if (from.z == 0 && to.z == 0) return on_segment_start;
  if (from.z == grid_.length_steps && to.z == grid_.length_steps) return on_segment_end;
  return drawn;
}

void OutlineCutter::add_edge(FarPoint a, FarPoint b, PieceSource source) {
  const std::int64_t width = grid_.sector_steps;
  if (a.u == b.u) {
    if (a.u % width != 0) {
      add_piece(a, b, source);
    } else {
      plane_.lines[around(a.u / width)].push_back(piece_of_line(a.z, b.z, source.origin));
    }
    return;
  }
  FarPoint from = a;
  for (std::int64_t line = (a.u / width - (a.u % width < 0)) * width + width; line < b.u;
       line += width) {
    const double part = static_cast<double>(line - a.u) / static_cast<double>(b.u - a.u);
    const FarPoint to{line, a.z + std::llround(part * static_cast<double>(b.z - a.z))};
    add_piece(from, to, source);
    from = to;
  }
  add_piece(from, b, source);
}

// A piece within one sector; cut further where it passes a height.
void OutlineCutter::add_piece(FarPoint a, FarPoint b, PieceSource source) {
  const std::int64_t width = grid_.sector_steps;
  const std::int64_t sector = a.u / width - (a.u % width < 0);
  const auto local = [&](FarPoint p) {
    return GridPoint{static_cast<std::int32_t>(p.u - sector * width),
                     static_cast<std::int32_t>(p.z)};
  };
  const std::size_t home = around(sector);
  GridPoint from = local(a);
  const GridPoint end = local(b);
  for (const std::int32_t height : heights_between(from.z, end.z)) {
    const double part = static_cast<double>(height - a.z) / static_cast<double>(b.z - a.z);
    const GridPoint to{
        static_cast<std::int32_t>(local(a).u + std::llround(part * static_cast<double>(b.u - a.u))),
        height};
    add_part(home, from, to, source);
    from = to;
  }
  add_part(home, from, end, source);
}

// A steep piece that starts on a sector line may have its first part rounded onto the line.
void OutlineCutter::add_part(std::size_t sector, GridPoint from, GridPoint to, PieceSource source) {
  if (from == to) return;
  const ArrangedEdge part = ordered(from, to, source);
  if (!lies_on_line(part, grid_.sector_steps)) {
    plane_.sectors[sector].push_back(part);
  } else {
    const std::size_t line = from.u == 0 ? sector : around(static_cast<std::int64_t>(sector) + 1);
    plane_.lines[line].push_back(piece_of_line(from.z, to.z, source.origin));
  }
}

// Sector or line i, counted on through any number of turns.
std::size_t OutlineCutter::around(std::int64_t i) const {
  return static_cast<std::size_t>(((i % grid_.sectors) + grid_.sectors) % grid_.sectors);
}

// The cut heights strictly between two heights, in the order in which they are passed.
std::vector<std::int32_t> OutlineCutter::heights_between(std::int32_t from, std::int32_t to) const {
  const auto first = std::upper_bound(cuts_.begin(), cuts_.end(), std::min(from, to));
  const auto last = std::lower_bound(cuts_.begin(), cuts_.end(), std::max(from, to));
  std::vector<std::int32_t> between(first, std::max(first, last));
  if (from > to) std::reverse(between.begin(), between.end());
  return between;
}

}  // namespace latticast
