// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "geometry/solid/geometry_error.h"
#include "geometry/solid/outline_cutter.h"

namespace latticast {
namespace {

constexpr double most_pieces = 20e6;
constexpr int most_passes = 1000;

using Sector = std::vector<ArrangedEdge>;
using Heights = std::vector<std::int32_t>;  // sorted, distinct

// How far along an edge a point lies, square to it: 0 at its start, `along(edge, edge.b)` at its
// end.
std::int64_t along(const ArrangedEdge& edge, GridPoint point) {
  return std::int64_t{edge.b.u - edge.a.u} * (point.u - edge.a.u) +
         std::int64_t{edge.b.z - edge.a.z} * (point.z - edge.a.z);
}

// Between the edge's ends, or one of them; not past an end, nor square beside it.
bool within(GridPoint point, const ArrangedEdge& edge) {
  const std::int64_t position = along(edge, point);
  return (position > 0 && position < along(edge, edge.b)) || point == edge.a || point == edge.b;
}

// Is the point within one step of the edge's inside (not of its ends)?
bool touches(GridPoint point, const ArrangedEdge& edge) {
  const std::int64_t position = along(edge, point);
  const std::int64_t length_squared = along(edge, edge.b);
  if (position <= 0 || position >= length_squared) return false;
  const auto off = static_cast<double>(turn(edge.a, edge.b, point));
  return off * off < static_cast<double>(length_squared);
}

bool crosses(const ArrangedEdge& e, const ArrangedEdge& f) {
  const auto side = [](std::int64_t x) { return (x > 0) - (x < 0); };
  return side(turn(e.a, e.b, f.a)) * side(turn(e.a, e.b, f.b)) < 0 &&
         side(turn(f.a, f.b, e.a)) * side(turn(f.a, f.b, e.b)) < 0;
}

GridPoint crossing_point(const ArrangedEdge& e, const ArrangedEdge& f) {
  const auto from = static_cast<double>(turn(f.a, f.b, e.a));
  const auto to = static_cast<double>(turn(f.a, f.b, e.b));
  const double part = from / (from - to);
  return {static_cast<std::int32_t>(e.a.u + std::lround(part * (e.b.u - e.a.u))),
          static_cast<std::int32_t>(e.a.z + std::lround(part * (e.b.z - e.a.z)))};
}

// A line between two sectors: the points and the pieces of outline on it.
struct Line {
  Heights& heights;
  LinePieces& pieces;
};

// One pass over one sector: finds where its edges must be cut, and cuts them.
class SectorSnapper {
 public:
  SectorSnapper(Sector& edges, Line left, Line right, std::int32_t sector_steps)
      : edges_(edges),
        left_(left),
        right_(right),
        sector_steps_(sector_steps),
        splits_(edges.size()) {
    for (const ArrangedEdge& edge : edges) points_.insert(points_.end(), {edge.a, edge.b});
    for (const std::int32_t z : left.heights) points_.push_back({0, z});
    for (const std::int32_t z : right.heights) points_.push_back({sector_steps, z});
    const auto by_height = [](GridPoint p, GridPoint q) {
      return p.z != q.z ? p.z < q.z : p.u < q.u;
    };
    std::sort(points_.begin(), points_.end(), by_height);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  // Returns whether anything changed.
  bool run() {
    find_touches();
    for (const auto& stops : splits_) is_touched_.push_back(stops.empty() ? 0 : 1);
    find_crossings();
    const bool changed =
        std::any_of(splits_.begin(), splits_.end(), [](auto& s) { return !s.empty(); });
    if (changed) apply_splits();
    return changed;
  }

 private:
  static std::int32_t low(const ArrangedEdge& edge) { return std::min(edge.a.z, edge.b.z); }
  static std::int32_t high(const ArrangedEdge& edge) { return std::max(edge.a.z, edge.b.z); }

  void find_touches() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const ArrangedEdge& edge = edges_[i];
      auto point = std::lower_bound(points_.begin(), points_.end(), low(edge) - 1,
                                    [](GridPoint p, std::int32_t z) { return p.z < z; });
      for (; point != points_.end() && point->z <= high(edge) + 1; ++point) {
        if (point->u < edge.a.u - 1 || point->u > edge.b.u + 1) continue;
        if (touches(*point, edge)) splits_[i].push_back(*point);
      }
    }
  }

  void find_crossings() {
    std::vector<std::size_t> order(edges_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](auto i, auto j) {
      return low(edges_[i]) != low(edges_[j]) ? low(edges_[i]) < low(edges_[j]) : i < j;
    });
    std::vector<std::size_t> active;
    for (const std::size_t i : order) {
      std::erase_if(active, [&](auto j) { return high(edges_[j]) < low(edges_[i]); });
      for (const std::size_t j : active) test_crossing(i, j);
      active.push_back(i);
    }
  }

  void test_crossing(std::size_t i, std::size_t j) {
    const ArrangedEdge& e = edges_[i];
    const ArrangedEdge& f = edges_[j];
    // Points that are there come first: they may already part the edges, where a point of their own
    // for every pair would let edges overtake each other along a grid line, ever farther away.
    if (is_touched_[i] || is_touched_[j]) return;
    if (e.b.u < f.a.u || f.b.u < e.a.u || !crosses(e, f)) return;
    const GridPoint point = crossing_point(e, f);
    // Where rounding takes the point past an end, that end touches the other edge, which is then
    // cut there; a cut here would only lengthen a piece, and passes could go round in circles.
    if (!within(point, e) || !within(point, f)) return;
    if (point != e.a && point != e.b) splits_[i].push_back(point);
    if (point != f.a && point != f.b) splits_[j].push_back(point);
  }

  void apply_splits() {
    Sector pieces;
    pieces.reserve(edges_.size() + points_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      GridPoint from = edges_[i].a;
      for (const GridPoint to : chain(edges_[i], std::move(splits_[i]))) {
        const PieceSource source{edges_[i].winding, edges_[i].origin};
        if (from != to) add(pieces, ordered(from, to, source));
        from = to;
      }
    }
    edges_ = std::move(pieces);
  }

  // The points that take an edge from its start over its stops to its end. Every piece is shorter
  // than the edge, so the passes come to an end. A chain over several stops of a short edge may
  // turn back and forth; a single stop never does, because it lies within one step of the edge.
  static std::vector<GridPoint> chain(const ArrangedEdge& edge, std::vector<GridPoint> stops) {
    if (stops.empty()) return {edge.b};
    std::sort(stops.begin(), stops.end(), [&](GridPoint p, GridPoint q) {
      const std::int64_t to_p = along(edge, p);
      const std::int64_t to_q = along(edge, q);
      return to_p != to_q ? to_p < to_q : p < q;
    });
    const GridPoint middle = stops[stops.size() / 2];
    stops.push_back(edge.b);
    GridPoint from = edge.a;
    for (const GridPoint to : stops) {
      if (along({from, to}, to) >= along(edge, edge.b)) return {middle, edge.b};
      from = to;
    }
    return stops;
  }

  void add(Sector& pieces, const ArrangedEdge& piece) {
    if (!lies_on_line(piece, sector_steps_)) {
      pieces.push_back(piece);
    } else {
      Line& line = piece.a.u == 0 ? left_ : right_;
      line.pieces.push_back(piece_of_line(piece.a.z, piece.b.z, piece.origin));
    }
  }

  Sector& edges_;
  Line left_;
  Line right_;
  std::int32_t sector_steps_;
  std::vector<GridPoint> points_;
  std::vector<std::vector<GridPoint>> splits_;
  std::vector<char> is_touched_;  // by edge: does a known point split it in this pass?
};

// Equal pieces become one, which comes from the smallest origin. Where two strands share a side the
// sum may be 0: such a piece bounds nothing.
void merge_equal(Sector& edges) {
  std::sort(edges.begin(), edges.end(), [](const ArrangedEdge& e, const ArrangedEdge& f) {
    return e.a != f.a ? e.a < f.a : e.b < f.b;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (kept > 0 && edges[kept - 1].a == edges[i].a && edges[kept - 1].b == edges[i].b) {
      edges[kept - 1].winding += edges[i].winding;
      edges[kept - 1].origin = std::min(edges[kept - 1].origin, edges[i].origin);
    } else {
      edges[kept++] = edges[i];
    }
  }
  edges.resize(kept);
}

// Adds the sector's points on one of its lines to the points known there; says whether any was new.
bool add_heights(const Sector& edges, std::int32_t line_u, Heights& known) {
  Heights found;
  for (const ArrangedEdge& edge : edges) {
    if (edge.a.u == line_u) found.push_back(edge.a.z);
    if (edge.b.u == line_u) found.push_back(edge.b.z);
  }
  std::sort(found.begin(), found.end());
  const std::size_t before = known.size();
  Heights all;
  std::set_union(known.begin(), known.end(), found.begin(), found.end(), std::back_inserter(all));
  all.erase(std::unique(all.begin(), all.end()), all.end());
  known = std::move(all);
  return known.size() != before;
}

void snap_until_clean(Arrangement& plane) {
  const int count = plane.grid.sectors;
  const std::int32_t width = plane.grid.sector_steps;
  std::vector<Heights> lines(count);
  for (int c = 0; c < count; ++c) {
    add_heights(plane.sectors[c], 0, lines[c]);
    add_heights(plane.sectors[c], width, lines[(c + 1) % count]);
  }
  std::vector<char> dirty(count, 1);
  for (int pass = 0; std::count(dirty.begin(), dirty.end(), 1) > 0; ++pass) {
    if (pass == most_passes) {
      throw GeometryError(
          "strands graze each other so finely that their crossings cannot be told "
          "apart; change an angle, a count or a width slightly");
    }
    for (int c = 0; c < count; ++c) {
      if (!dirty[c]) continue;
      const int next = (c + 1) % count;
      Sector& edges = plane.sectors[c];
      const Line left{lines[c], plane.lines[c]};
      const Line right{lines[next], plane.lines[next]};
      dirty[c] = SectorSnapper(edges, left, right, width).run() ? 1 : 0;
      if (!dirty[c]) continue;
      merge_equal(edges);
      if (add_heights(edges, 0, lines[c])) dirty[(c + count - 1) % count] = 1;
      if (add_heights(edges, width, lines[next])) dirty[next] = 1;
    }
  }
}

// How many pieces the sector lines and the cuts will make of the outlines, before any is made.
double outline_pieces(const Pattern& pattern, const PlaneGrid& grid, std::size_t cuts) {
  const double sector_width = pattern.circumference_mm / grid.sectors;
  const double cut_spacing = pattern.length_mm / static_cast<double>(cuts + 1);
  double pieces = 0;
  for (const Strand& strand : pattern.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& from = strand.outline[i];
      const PlanePoint& to = strand.outline[(i + 1) % strand.outline.size()];
      pieces += 1 + std::abs(to.u - from.u) / sector_width + std::abs(to.z - from.z) / cut_spacing;
    }
  }
  return pieces;
}

}  // namespace

Arrangement arrange(std::span<const Pattern> sheets, const PlaneGrid& grid,
                    std::span<const std::int32_t> cuts) {
  double pieces = static_cast<double>(cuts.size()) * grid.sectors;
  for (const Pattern& pattern : sheets) pieces += outline_pieces(pattern, grid, cuts.size());
  if (!(pieces <= most_pieces)) {
    throw GeometryError("the lattice would need about " +
                        std::to_string(std::llround(pieces / 1e6)) +
                        " million outline pieces; the limit is 20 million: use fewer strands, a "
                        "steeper angle, a shorter segment or a coarser tolerance");
  }
  Arrangement plane{.grid = grid,
                    .cuts = {cuts.begin(), cuts.end()},
                    .sectors = std::vector<Sector>(grid.sectors),
                    .lines = std::vector<LinePieces>(grid.sectors),
                    .drawn = drawn_edges(sheets)};
  OutlineCutter cutter(cuts, plane);
  EdgeOrigin first = 0;
  for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet) {
    for (const Strand& strand : sheets[sheet].strands) {
      cutter.add_outline(strand.outline, winding_on(static_cast<int>(sheet)), first);
      first += static_cast<EdgeOrigin>(strand.outline.size());
    }
  }
  for (Sector& sector : plane.sectors) {
    for (const std::int32_t z : cuts) sector.push_back({{0, z}, {grid.sector_steps, z}, 0, on_cut});
    merge_equal(sector);
  }
  snap_until_clean(plane);
  return plane;
}

Arrangement arrange(const Pattern& pattern, const PlaneGrid& grid,
                    std::span<const std::int32_t> cuts) {
  return arrange(std::span(&pattern, 1), grid, cuts);
}

}  // namespace latticast
