// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/flat_pattern.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <string>
#include <utility>

#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/region.h"
#include "geometry/solid/tolerance_budget.h"

namespace latticast {
namespace {

constexpr int few_sectors = 4;  // sectors only cut outlines; a quarter of the way around is exact
constexpr int most_slit_rounds = 16;

// A grid point of the slit plane, u counted from the slit all the way across.
struct SlitPoint {
  std::int64_t u = 0;
  std::int64_t z = 0;

  friend auto operator<=>(const SlitPoint&, const SlitPoint&) = default;
};

// Material lies on the left of from -> to.
struct SlitEdge {
  SlitPoint from;
  SlitPoint to;
};

using Loop = std::vector<SlitPoint>;

struct PieceLoops {
  Loop outer;
  std::int64_t twice_area = 0;
  std::vector<Loop> holes;
};

std::int64_t turn(SlitPoint a, SlitPoint b, SlitPoint c) {
  return (b.u - a.u) * (c.z - a.z) - (b.z - a.z) * (c.u - a.u);
}

void check_widths(const Lattice& lattice, const PlaneGrid& grid) {
  const double thinnest = thinnest_strand_mm(lattice);
  const double least = least_width_mm(grid);
  if (thinnest >= least) return;
  throw GeometryError("a strand or ring of " + std::to_string(thinnest) +
                      " mm is too thin to be drawn on a sheet this large; here it needs at least " +
                      std::to_string(least) + " mm");
}

// Heights at which an opening's tip touches the slit, material being whole below and above it on
// both sides: there the slit would leave material hanging together in a point.
std::vector<std::int32_t> slit_tips(const Region& region) {
  std::vector<std::int32_t> tips;
  Layers below = 0;
  for (const LinePoint& point : line_points(region, 0)) {
    const Layers above = point.inside_before & point.inside_after;
    if (below != 0 && above != 0) tips.push_back(point.z);
    below = above;
  }
  return tips;
}

Strand diamond(double z_mm, double half_mm, double length_mm) {
  return {{{0, std::max(0.0, z_mm - half_mm)},
           {half_mm, z_mm},
           {0, std::min(length_mm, z_mm + half_mm)},
           {-half_mm, z_mm}}};
}

Region slit_region(LatticeDrawing& drawing, const ToleranceBudget& budget, const PlaneGrid& grid) {
  const double half = std::max(budget.closing_mm, least_width_mm(grid));
  Region region = drawing.united(budget.drawing_mm, grid, {}, budget.closing_mm);
  Pattern pattern = drawing.outlines(budget.drawing_mm);
  for (int round = 0; round < most_slit_rounds; ++round) {
    const std::vector<std::int32_t> tips = slit_tips(region);
    if (tips.empty()) return region;
    for (const std::int32_t z : tips) {
      pattern.strands.push_back(diamond(z * grid.z_step_mm, half, pattern.length_mm));
    }
    pattern.error += {half, 2 * half * half * static_cast<double>(tips.size())};
    region = unite(pattern, grid, {}, budget.closing_mm);
  }
  throw GeometryError(
      "the slit meets openings in points that cannot be closed; change an angle, a "
      "count or a width slightly");
}

// Outlines along a sector line, or along the slit, where the slit plane has two sides.
void add_line_edges(const Region& region, int line, std::vector<SlitEdge>& edges) {
  const std::int64_t u = std::int64_t{line} * region.grid.sector_steps;
  const std::int64_t far_u = std::int64_t{region.grid.sectors} * region.grid.sector_steps;
  const std::vector<LinePoint> points = line_points(region, line);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const std::int64_t low = points[i].z;
    const std::int64_t high = points[i + 1].z;
    const bool before = points[i].inside_before != 0;
    const bool after = points[i].inside_after != 0;
    if (line != 0 && before == after) continue;
    if (before) edges.push_back({{line == 0 ? far_u : u, low}, {line == 0 ? far_u : u, high}});
    if (after) edges.push_back({{u, high}, {u, low}});
  }
}

// Sorted by where they start.
std::vector<SlitEdge> slit_edges(const Region& region) {
  std::vector<SlitEdge> edges;
  for (int c = 0; c < region.grid.sectors; ++c) {
    const std::int64_t left = std::int64_t{c} * region.grid.sector_steps;
    for (const RegionEdge& edge : region.sectors[c]) {
      if (!edge.is_outline()) continue;
      const SlitPoint a{left + edge.a.u, edge.a.z};
      const SlitPoint b{left + edge.b.u, edge.b.z};
      edges.push_back(edge.inside_left != 0 ? SlitEdge{a, b} : SlitEdge{b, a});
    }
    add_line_edges(region, c, edges);
  }
  std::sort(edges.begin(), edges.end(),
            [](const SlitEdge& e, const SlitEdge& f) { return e.from < f.from; });
  return edges;
}

// Points on the slit are kept even on a straight line: there the other side may turn.
Loop without_straight_points(const Loop& loop, std::int64_t far_u) {
  Loop kept;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool on_slit = loop[i].u == 0 || loop[i].u == far_u;
    if (on_slit || turn(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]) != 0) {
      kept.push_back(loop[i]);
    }
  }
  return kept;
}

std::int64_t twice_area(const Loop& loop) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += turn(loop[0], loop[i], loop[i + 1]);
  return sum;
}

// Every point of the slit plane starts exactly one edge. Loops begin at their first point, and come
// in the order of these.
std::vector<Loop> loops_of(const Region& region) {
  const std::int64_t far_u = std::int64_t{region.grid.sectors} * region.grid.sector_steps;
  const std::vector<SlitEdge> edges = slit_edges(region);
  std::vector<char> used(edges.size(), 0);
  std::vector<Loop> loops;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first] != 0) continue;
    Loop loop;
    for (std::size_t at = first; used[at] == 0;) {
      used[at] = 1;
      loop.push_back(edges[at].from);
      const auto next = std::lower_bound(
          edges.begin(), edges.end(), edges[at].to,
          [](const SlitEdge& edge, const SlitPoint& point) { return edge.from < point; });
      at = static_cast<std::size_t>(next - edges.begin());
    }
    loops.push_back(without_straight_points(loop, far_u));
  }
  return loops;
}

// Precondition: the point is not on the loop.
bool surrounds(const Loop& loop, SlitPoint point) {
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    if ((loop[i].z > point.z) == (loop[j].z > point.z)) continue;
    const bool upwards = loop[i].z > loop[j].z;
    const std::int64_t side = turn(loop[j], loop[i], point);
    if (upwards ? side > 0 : side < 0) inside = !inside;
  }
  return inside;
}

std::vector<PieceLoops> pieces_of(std::vector<Loop> loops) {
  std::vector<PieceLoops> pieces;
  std::vector<Loop> holes;
  for (Loop& loop : loops) {
    const std::int64_t area = twice_area(loop);
    if (area > 0) {
      pieces.push_back({std::move(loop), area, {}});
    } else {
      holes.push_back(std::move(loop));
    }
  }
  for (Loop& hole : holes) {
    PieceLoops* around = nullptr;
    for (PieceLoops& piece : pieces) {
      const bool smaller = around == nullptr || piece.twice_area < around->twice_area;
      if (smaller && (pieces.size() == 1 || surrounds(piece.outer, hole.front()))) around = &piece;
    }
    around->holes.push_back(std::move(hole));
  }
  return pieces;
}

std::vector<PlanePoint> in_mm(const Loop& loop, const PlaneGrid& grid, double length_mm) {
  std::vector<PlanePoint> points;
  points.reserve(loop.size());
  for (const SlitPoint& p : loop) {
    const double z =
        p.z == grid.length_steps ? length_mm : static_cast<double>(p.z) * grid.z_step_mm;
    points.push_back({static_cast<double>(p.u) * grid.u_step_mm, z});
  }
  return points;
}

}  // namespace

FlatPattern flat_pattern(const Segment& segment, double tolerance_mm) {
  LatticeDrawing drawing(segment, tolerance_mm);
  return flat_pattern(drawing, tolerance_mm);
}

FlatPattern flat_pattern(LatticeDrawing& drawing, double tolerance_mm) {
  const Lattice& lattice = *drawing.segment().lattice;
  const ToleranceBudget budget = flat_pattern_budget(lattice, tolerance_mm);
  const Pattern& pattern = drawing.outlines(budget.drawing_mm);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, pattern.length_mm, few_sectors);
  check_widths(lattice, grid);
  FlatPattern flat;
  flat.radius_mm = drawing.segment().lattice_mid_radius_mm();
  flat.circumference_mm = pattern.circumference_mm;
  flat.length_mm = pattern.length_mm;
  const Region region = slit_region(drawing, budget, grid);
  flat.error = region_error(region);
  flat.area_mm2 = area_mm2(region);
  for (const PieceLoops& piece : pieces_of(loops_of(region))) {
    FlatPiece& drawn = flat.pieces.emplace_back();
    drawn.outer = in_mm(piece.outer, grid, flat.length_mm);
    for (const Loop& hole : piece.holes) {
      drawn.holes.push_back(in_mm(hole, grid, flat.length_mm));
    }
  }
  return flat;
}

}  // namespace latticast
