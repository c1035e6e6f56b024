// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/region.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "geometry/solid/arrangement.h"

namespace latticast {
namespace {

constexpr int most_closing_rounds = 16;

// Sweeps one column from left to right (upwards along vertical edges) and finds the winding number
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
    int winding = at == status_.begin() ? 0 : above_[*(at - 1)];
    for (const std::uint32_t edge : starting) {
      const int below = winding;
      winding += edges_[edge].winding;
      above_[edge] = winding;
      visit(edges_[edge], below, winding);
    }
    status_.insert(at, starting.begin(), starting.end());
  }

  const std::vector<ArrangedEdge>& edges_;
  std::vector<int> above_;             // winding number on the left of each edge
  std::vector<std::uint32_t> status_;  // edges that the sweep line meets, from below
};

std::vector<RegionEdge> region_edges(const std::vector<ArrangedEdge>& edges,
                                     const std::vector<std::int32_t>& cuts) {
  std::vector<RegionEdge> kept;
  WindingSweep(edges).run([&](const ArrangedEdge& edge, int below, int above) {
    const RegionEdge side{edge.a, edge.b, above > 0, below > 0};
    const bool on_cut =
        edge.a.z == edge.b.z && std::binary_search(cuts.begin(), cuts.end(), edge.a.z);
    if (side.is_outline() || (side.inside_left && on_cut)) kept.push_back(side);
  });
  return kept;
}

Region region_of(const Arrangement& plane) {
  Region region{plane.grid, {}};
  region.columns.reserve(plane.columns.size());
  for (const auto& column : plane.columns) {
    region.columns.push_back(region_edges(column, plane.cuts));
  }
  return region;
}

struct PlaneVertex {
  int column = 0;  // of a vertex on a line: the column on the line's right
  GridPoint point;
  friend bool operator==(const PlaneVertex&, const PlaneVertex&) = default;
};

struct PlaneVertexHash {
  std::size_t operator()(const PlaneVertex& v) const {
    const auto low = static_cast<std::uint64_t>(v.point.z) * 0x9E3779B97F4A7C15ULL;
    const auto high =
        (static_cast<std::uint64_t>(v.column) << 32U) + static_cast<std::uint64_t>(v.point.u);
    return static_cast<std::size_t>((low ^ high) * 0xD6E8FEB86659FD93ULL >> 7U);
  }
};

PlaneVertex vertex_of(const PlaneGrid& grid, int column, GridPoint point) {
  if (point.u == grid.column_steps) return {(column + 1) % grid.columns, {0, point.z}};
  return {column, point};
}

// Calls visit(vertex, vertex) for every outline edge, those along column lines included.
template <class Visit>
void for_each_outline_edge(const Region& region, Visit&& visit) {
  for (int c = 0; c < region.grid.columns; ++c) {
    for (const RegionEdge& edge : region.columns[c]) {
      if (!edge.is_outline()) continue;
      visit(vertex_of(region.grid, c, edge.a), vertex_of(region.grid, c, edge.b));
    }
    const std::vector<LinePoint> points = line_points(region, c);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].inside_before == points[i].inside_after) continue;
      visit(PlaneVertex{c, {0, points[i].z}}, PlaneVertex{c, {0, points[i + 1].z}});
    }
  }
}

using VertexIndex = std::unordered_map<PlaneVertex, std::uint32_t, PlaneVertexHash>;

// Points where more than two outline edges meet: material touches itself there and nowhere around.
std::vector<PlaneVertex> touching_points(const Region& region) {
  std::unordered_map<PlaneVertex, int, PlaneVertexHash> degree;
  for_each_outline_edge(region, [&](const PlaneVertex& a, const PlaneVertex& b) {
    ++degree[a];
    ++degree[b];
  });
  std::vector<PlaneVertex> points;
  for (const auto& [vertex, count] : degree) {
    if (count > 2) points.push_back(vertex);
  }
  std::sort(points.begin(), points.end(), [](const PlaneVertex& a, const PlaneVertex& b) {
    return a.column != b.column ? a.column < b.column : a.point < b.point;
  });
  return points;
}

Strand diamond(const PlaneGrid& grid, const PlaneVertex& at, double half) {
  const double u =
      (static_cast<double>(at.column) * grid.column_steps + at.point.u) * grid.u_step_mm;
  const double z = at.point.z * grid.z_step_mm;
  const double length = grid.length_steps * grid.z_step_mm;
  return {{{u, std::max(0.0, z - half)},
           {u + half, z},
           {u, std::min(length, z + half)},
           {u - half, z}}};
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

Region unite(Pattern pattern, const PlaneGrid& grid, std::span<const std::int32_t> cuts,
             double closing_mm) {
  const double half = std::max(closing_mm, 16 * std::max(grid.u_step_mm, grid.z_step_mm));
  for (int round = 0; round < most_closing_rounds; ++round) {
    Region region = region_of(arrange(pattern, grid, cuts));
    const std::vector<PlaneVertex> points = touching_points(region);
    if (points.empty()) return region;
    for (const PlaneVertex& point : points) pattern.strands.push_back(diamond(grid, point, half));
  }
  throw GeometryError(
      "strands touch in points that cannot be closed; change an angle, a count or a "
      "width slightly");
}

std::vector<LinePoint> line_points(const Region& region, int line) {
  const int before = (line + region.grid.columns - 1) % region.grid.columns;
  std::vector<LinePoint> points;  // the flags first say: does an outline edge end here?
  for (const RegionEdge& edge : region.columns[before]) {
    if (edge.b.u == region.grid.column_steps) {
      points.push_back({edge.b.z, edge.is_outline(), false});
    }
  }
  for (const RegionEdge& edge : region.columns[line]) {
    if (edge.a.u == 0) points.push_back({edge.a.z, false, edge.is_outline()});
  }
  std::sort(points.begin(), points.end(), [](auto& p, auto& q) { return p.z < q.z; });
  // Going up along a line, each outline edge that ends on it is crossed once.
  std::size_t kept = 0;
  bool inside_before = false;
  bool inside_after = false;
  for (const LinePoint& point : points) {
    inside_before ^= point.inside_before;
    inside_after ^= point.inside_after;
    if (kept == 0 || points[kept - 1].z != point.z) ++kept;
    points[kept - 1] = {point.z, inside_before, inside_after};
  }
  points.resize(kept);
  return points;
}

double area_mm2(const Region& region) {
  std::int64_t twice_steps = 0;
  for (const auto& column : region.columns) {
    for (const RegionEdge& edge : column) {
      if (!edge.is_outline()) continue;
      const std::int64_t under =
          std::int64_t{edge.b.u - edge.a.u} * (std::int64_t{edge.a.z} + edge.b.z);
      twice_steps += edge.inside_right ? under : -under;
    }
  }
  return 0.5 * static_cast<double>(twice_steps) * region.grid.u_step_mm * region.grid.z_step_mm;
}

int outline_loops(const Region& region) {
  VertexIndex index;
  std::vector<std::uint32_t> parent;
  const auto index_of = [&](const PlaneVertex& vertex) {
    const auto [at, is_new] = index.try_emplace(vertex, static_cast<std::uint32_t>(parent.size()));
    if (is_new) parent.push_back(at->second);
    return at->second;
  };
  int loops = 0;
  for_each_outline_edge(region, [&](const PlaneVertex& a, const PlaneVertex& b) {
    const std::size_t known = parent.size();
    const std::uint32_t i = find_root(parent, index_of(a));
    const std::uint32_t j = find_root(parent, index_of(b));
    loops += static_cast<int>(parent.size() - known);
    if (i == j) return;
    parent[i] = j;
    --loops;
  });
  return loops;
}

}  // namespace latticast
