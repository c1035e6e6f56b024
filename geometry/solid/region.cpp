// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"

namespace latticast {
namespace {

constexpr int most_closing_rounds = 16;
constexpr double farthest_snap = 1.5;  // in steps
constexpr double usual_snap = 0.5;

// Sweeps one sector from left to right (upwards along vertical edges) and finds the winding number
// on both sides of every edge. Edges meet at their ends only, so the order of the edges that the
// sweep line meets changes at vertices alone.
class WindingSweep {
 public:
  explicit WindingSweep(const std::vector<ArrangedEdge>& edges)
      : edges_(edges), above_(edges.size()) {}

  // Calls visit(edge, winding on its right, winding on its left) for every edge.
  template <class Visit>
  void run(Visit&& visit) {
    // merge_equal left the edges sorted by a; by_end_ gives them sorted by b.
    std::vector<std::uint32_t> by_start(edges_.size());
    std::iota(by_start.begin(), by_start.end(), 0U);
    std::vector<std::uint32_t> by_end = by_start;
    std::sort(by_start.begin(), by_start.end(),
              [&](auto i, auto j) { return edges_[i].a < edges_[j].a; });
    std::sort(by_end.begin(), by_end.end(),
              [&](auto i, auto j) { return edges_[i].b < edges_[j].b; });
    std::size_t ended = 0;
    for (std::size_t first = 0; first < by_start.size();) {
      const GridPoint vertex = edges_[by_start[first]].a;
      for (; ended < by_end.size() && edges_[by_end[ended]].b <= vertex; ++ended) {
        remove(by_end[ended]);
      }
      std::size_t last = first;
      while (last < by_start.size() && edges_[by_start[last]].a == vertex) ++last;
      insert({by_start.data() + first, by_start.data() + last}, vertex, visit);
      first = last;
    }
  }

 private:
  void remove(std::uint32_t edge) {
    const GridPoint end = edges_[edge].b;
    auto at = std::partition_point(status_.begin(), status_.end(), [&](std::uint32_t other) {
      return edges_[other].b != end && turn(edges_[other].a, edges_[other].b, end) > 0;
    });
    status_.erase(std::find(at, status_.end(), edge));
  }

  template <class Visit>
  void insert(std::span<std::uint32_t> starting, GridPoint vertex, Visit&& visit) {
    std::sort(starting.begin(), starting.end(),
              [&](auto i, auto j) { return turn(vertex, edges_[i].b, edges_[j].b) > 0; });
    const auto at = std::partition_point(status_.begin(), status_.end(), [&](std::uint32_t other) {
      return turn(edges_[other].a, edges_[other].b, vertex) > 0;
    });
    std::int64_t winding = at == status_.begin() ? 0 : above_[*(at - 1)];
    for (const std::uint32_t edge : starting) {
      const std::int64_t below = winding;
      winding += edges_[edge].winding;
      above_[edge] = winding;
      visit(edges_[edge], below, winding);
    }
    status_.insert(at, starting.begin(), starting.end());
  }

  const std::vector<ArrangedEdge>& edges_;
  std::vector<std::int64_t> above_;    // winding number on the left of each edge
  std::vector<std::uint32_t> status_;  // edges that the sweep line meets, from below
};

// Bit s: sheet s covers the place.
unsigned covering_sheets(std::int64_t winding) {
  unsigned sheets = 0;
  for (int sheet = 0; sheet < most_sheets; ++sheet) {
    if (winding_of_sheet(winding, sheet) > 0) sheets |= 1U << sheet;
  }
  return sheets;
}

std::vector<RegionEdge> region_edges(const std::vector<ArrangedEdge>& edges,
                                     const std::vector<std::int32_t>& cuts,
                                     const Filling& filling) {
  std::vector<RegionEdge> kept;
  WindingSweep(edges).run([&](const ArrangedEdge& edge, std::int64_t below, std::int64_t above) {
    RegionEdge side{edge.a, edge.b, filling(covering_sheets(above)),
                    filling(covering_sheets(below)), edge.origin};
    const bool is_cut =
        edge.a.z == edge.b.z && std::binary_search(cuts.begin(), cuts.end(), edge.a.z);
    if (!side.is_outline()) side.origin = on_cut;
    if (side.is_outline() || (side.inside_left != 0 && is_cut)) kept.push_back(side);
  });
  return kept;
}

Region region_of(Arrangement plane, const Filling& filling) {
  Region region;
  region.grid = plane.grid;
  region.lines = std::move(plane.lines);
  region.drawn = std::move(plane.drawn);
  region.sectors.reserve(plane.sectors.size());
  for (const auto& sector : plane.sectors) {
    region.sectors.push_back(region_edges(sector, plane.cuts, filling));
  }
  return region;
}

// A single sheet is layer 0 itself.
Layers same_as_sheets(unsigned sheets) {
  return sheets;
}

struct PlaneVertex {
  int sector = 0;  // of a vertex on a line: the sector on the line's right
  GridPoint point;
  friend bool operator==(const PlaneVertex&, const PlaneVertex&) = default;
};

struct PlaneVertexHash {
  std::size_t operator()(const PlaneVertex& v) const {
    const auto low = static_cast<std::uint64_t>(v.point.z) * 0x9E3779B97F4A7C15ULL;
    const auto high =
        (static_cast<std::uint64_t>(v.sector) << 32U) + static_cast<std::uint64_t>(v.point.u);
    return static_cast<std::size_t>((low ^ high) * 0xD6E8FEB86659FD93ULL >> 7U);
  }
};

PlaneVertex vertex_of(const PlaneGrid& grid, int sector, GridPoint point) {
  if (point.u == grid.sector_steps) return {(sector + 1) % grid.sectors, {0, point.z}};
  return {sector, point};
}

// Calls visit(vertex, vertex, layers that end there) for every outline edge, those along sector
// lines included.
template <class Visit>
void for_each_outline_edge(const Region& region, Visit&& visit) {
  for (int c = 0; c < region.grid.sectors; ++c) {
    for (const RegionEdge& edge : region.sectors[c]) {
      if (!edge.is_outline()) continue;
      visit(vertex_of(region.grid, c, edge.a), vertex_of(region.grid, c, edge.b),
            edge.inside_left ^ edge.inside_right);
    }
    const std::vector<LinePoint> points = line_points(region, c);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].inside_before == points[i].inside_after) continue;
      visit(PlaneVertex{c, {0, points[i].z}}, PlaneVertex{c, {0, points[i + 1].z}},
            points[i].inside_before ^ points[i].inside_after);
    }
  }
}

using VertexIndex = std::unordered_map<PlaneVertex, std::uint32_t, PlaneVertexHash>;

// Outline edges of every layer that meet in a vertex, eight bits a layer.
using OutlineDegrees = std::uint64_t;
constexpr int most_layers = 8;

OutlineDegrees one_edge_of(Layers layers) {
  OutlineDegrees degrees = 0;
  for (int layer = 0; layer < most_layers; ++layer) {
    degrees |= OutlineDegrees{(layers >> layer) & 1U} << (8 * layer);
  }
  return degrees;
}

bool any_above_two(OutlineDegrees degrees) {
  for (; degrees != 0; degrees >>= 8) {
    if ((degrees & 0xFF) > 2) return true;
  }
  return false;
}

// Points where more than two outline edges of a layer meet: its material touches itself there and
// nowhere around.
std::vector<PlaneVertex> touching_points(const Region& region) {
  std::unordered_map<PlaneVertex, OutlineDegrees, PlaneVertexHash> degree;
  for_each_outline_edge(region, [&](const PlaneVertex& a, const PlaneVertex& b, Layers layers) {
    degree[a] += one_edge_of(layers);
    degree[b] += one_edge_of(layers);
  });
  std::vector<PlaneVertex> points;
  for (const auto& [vertex, degrees] : degree) {
    if (any_above_two(degrees)) points.push_back(vertex);
  }
  std::sort(points.begin(), points.end(), [](const PlaneVertex& a, const PlaneVertex& b) {
    return a.sector != b.sector ? a.sector < b.sector : a.point < b.point;
  });
  return points;
}

Strand diamond(const PlaneGrid& grid, const PlaneVertex& at, double half) {
  const double u =
      (static_cast<double>(at.sector) * grid.sector_steps + at.point.u) * grid.u_step_mm;
  const double z = at.point.z * grid.z_step_mm;
  const double length = grid.length_steps * grid.z_step_mm;
  return {{{u, std::max(0.0, z - half)},
           {u + half, z},
           {u, std::min(length, z + half)},
           {u - half, z}}};
}

struct ClosedPattern {
  Pattern pattern;
  Region region;
};

// Adds diamonds until nothing touches itself in a point.
ClosedPattern close_touching(Pattern pattern, const PlaneGrid& grid,
                             std::span<const std::int32_t> cuts, double closing_mm) {
  const double half = std::max(closing_mm, 16 * std::max(grid.u_step_mm, grid.z_step_mm));
  for (int round = 0; round < most_closing_rounds; ++round) {
    Region region = region_of(arrange(pattern, grid, cuts), same_as_sheets);
    const std::vector<PlaneVertex> points = touching_points(region);
    if (points.empty()) {
      region.error = pattern.error;
      return {std::move(pattern), std::move(region)};
    }
    for (const PlaneVertex& point : points) pattern.strands.push_back(diamond(grid, point, half));
    pattern.error += {half, 2 * half * half * static_cast<double>(points.size())};
  }
  throw GeometryError(
      "strands touch in points that cannot be closed; change an angle, a count or a "
      "width slightly");
}

}  // namespace

Pattern closed_pattern(Pattern pattern, const PlaneGrid& grid, double closing_mm) {
  return close_touching(std::move(pattern), grid, {}, closing_mm).pattern;
}

Region unite(Pattern pattern, const PlaneGrid& grid, std::span<const std::int32_t> cuts,
             double closing_mm) {
  return close_touching(std::move(pattern), grid, cuts, closing_mm).region;
}

Region layered_region(std::span<const Pattern> sheets, const PlaneGrid& grid,
                      std::span<const std::int32_t> cuts, const Filling& filling) {
  Region region = region_of(arrange(sheets, grid, cuts), filling);
  for (const Pattern& sheet : sheets) region.error += sheet.error;
  if (const std::vector<PlaneVertex> points = touching_points(region); !points.empty()) {
    const PlaneVertex& first = points.front();
    const double turn = (first.sector + static_cast<double>(first.point.u) / grid.sector_steps) /
                        static_cast<double>(grid.sectors);
    throw GeometryError("material touches itself in a point, at " + std::to_string(360 * turn) +
                        " degrees around the tube and z = " +
                        std::to_string(first.point.z * grid.z_step_mm) + " mm");
  }
  return region;
}

std::vector<LinePoint> line_points(const Region& region, int line) {
  const int before = (line + region.grid.sectors - 1) % region.grid.sectors;
  std::vector<LinePoint> points;  // first they say which layers' outline edges end here
  for (const RegionEdge& edge : region.sectors[before]) {
    if (edge.b.u == region.grid.sector_steps) {
      points.push_back({edge.b.z, edge.inside_left ^ edge.inside_right, 0});
    }
  }
  for (const RegionEdge& edge : region.sectors[line]) {
    if (edge.a.u == 0) points.push_back({edge.a.z, 0, edge.inside_left ^ edge.inside_right});
  }
  std::sort(points.begin(), points.end(), [](auto& p, auto& q) { return p.z < q.z; });
  // Going up along a line, each outline edge that ends on it is crossed once.
  std::size_t kept = 0;
  Layers inside_before = 0;
  Layers inside_after = 0;
  for (const LinePoint& point : points) {
    inside_before ^= point.inside_before;
    inside_after ^= point.inside_after;
    if (kept == 0 || points[kept - 1].z != point.z) ++kept;
    points[kept - 1] = {point.z, inside_before, inside_after};
  }
  points.resize(kept);
  return points;
}

EdgeOrigin origin_on_line(const Region& region, int line, std::int32_t low, std::int32_t high) {
  EdgeOrigin origin = on_sector_line;
  for (const LinePiece& piece : region.lines[line]) {
    if (piece.low < high && piece.high > low) origin = std::min(origin, piece.origin);
  }
  return origin;
}

double area_mm2(const Region& region, int layer) {
  const Layers wanted = Layers{1} << layer;
  std::int64_t twice_steps = 0;
  for (const auto& sector : region.sectors) {
    for (const RegionEdge& edge : sector) {
      if (((edge.inside_left ^ edge.inside_right) & wanted) == 0) continue;
      const std::int64_t under =
          std::int64_t{edge.b.u - edge.a.u} * (std::int64_t{edge.a.z} + edge.b.z);
      twice_steps += (edge.inside_right & wanted) != 0 ? under : -under;
    }
  }
  return 0.5 * static_cast<double>(twice_steps) * region.grid.u_step_mm * region.grid.z_step_mm;
}

DrawingError region_error(const Region& region, int layer) {
  const PlaneGrid& grid = region.grid;
  const Layers wanted = Layers{1} << layer;
  double snapped = 0;  // area that a displacement by one step takes or adds
  for (const auto& sector : region.sectors) {
    for (const RegionEdge& edge : sector) {
      if (((edge.inside_left ^ edge.inside_right) & wanted) == 0) continue;
      const bool on_end = edge.a.z == edge.b.z && (edge.a.z == 0 || edge.a.z == grid.length_steps);
      if (on_end) continue;
      snapped += std::abs(edge.b.z - edge.a.z) + std::abs(edge.b.u - edge.a.u);
    }
  }
  DrawingError error = region.error;
  if (snapped == 0) return error;
  error.distance_mm += farthest_snap * std::hypot(grid.u_step_mm, grid.z_step_mm);
  error.area_mm2 += usual_snap * snapped * grid.u_step_mm * grid.z_step_mm;
  return error;
}

std::vector<OutlineCurve> outline_curves(const Region& region) {
  constexpr std::uint32_t none = UINT32_MAX;
  VertexIndex index;
  std::vector<PlanePoint> places;
  std::vector<std::array<std::uint32_t, 2>> neighbours;
  const PlaneGrid& grid = region.grid;
  const auto index_of = [&](const PlaneVertex& vertex) {
    const auto [at, is_new] = index.try_emplace(vertex, static_cast<std::uint32_t>(places.size()));
    if (is_new) {
      const double steps = static_cast<double>(vertex.sector) * grid.sector_steps + vertex.point.u;
      places.push_back({steps * grid.u_step_mm, vertex.point.z * grid.z_step_mm});
      neighbours.push_back({none, none});
    }
    return at->second;
  };
  const auto join = [&](std::uint32_t from, std::uint32_t to) {
    neighbours[from][neighbours[from][0] == none ? 0 : 1] = to;
  };
  for_each_outline_edge(region, [&](const PlaneVertex& a, const PlaneVertex& b, Layers layers) {
    if ((layers & 1U) == 0) return;
    const std::uint32_t i = index_of(a);
    const std::uint32_t j = index_of(b);
    join(i, j);
    join(j, i);
  });
  const double circumference = grid.sectors * grid.sector_steps * grid.u_step_mm;
  std::vector<char> seen(places.size(), 0);
  std::vector<OutlineCurve> curves;
  for (std::uint32_t first = 0; first < places.size(); ++first) {
    if (seen[first] != 0) continue;
    OutlineCurve curve;
    double u = places[first].u;
    std::uint32_t before = none;
    std::uint32_t at = first;
    do {
      seen[at] = 1;
      curve.points.push_back({u, places[at].z});
      const auto& [one, other] = neighbours[at];
      const std::uint32_t next = before == none || one == before ? other : one;
      u += std::remainder(places[next].u - places[at].u, circumference);
      before = at;
      at = next;
    } while (at != first);
    curve.around_mm = circumference * std::round((u - places[first].u) / circumference);
    curves.push_back(std::move(curve));
  }
  return curves;
}

int outline_loops(const Region& region) {
  VertexIndex index;
  DisjointSets curves(0);
  const auto index_of = [&](const PlaneVertex& vertex) {
    const auto [at, is_new] = index.try_emplace(vertex, static_cast<std::uint32_t>(curves.size()));
    if (is_new) curves.add();
    return at->second;
  };
  int loops = 0;
  for_each_outline_edge(region, [&](const PlaneVertex& a, const PlaneVertex& b, Layers layers) {
    if ((layers & 1U) == 0) return;
    const std::size_t known = curves.size();
    const std::uint32_t i = index_of(a);
    const std::uint32_t j = index_of(b);
    loops += static_cast<int>(curves.size() - known);
    if (curves.join(i, j)) --loops;
  });
  return loops;
}

}  // namespace latticast
