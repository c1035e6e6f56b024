// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/sector_triangles.h"

namespace latticast {
namespace {

// Numbers the vertices of a region and collects each sector's edges.
class Builder {
 public:
  explicit Builder(const Region& region) : region_(region), lines_(region.grid.sectors) {
    mesh_.grid = region.grid;
    mesh_.drawn = region.drawn;
    for (int line = 0; line < region.grid.sectors; ++line) {
      lines_[line] = line_points(region, line);
      first_on_line_.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
      for (const LinePoint& point : lines_[line]) mesh_.vertices.push_back({line, {0, point.z}});
    }
  }

  PlaneMesh run() {
    for (int line = 0; line < region_.grid.sectors; ++line) add_line_outline(line);
    for (int sector = 0; sector < region_.grid.sectors; ++sector) add_sector(sector);
    return std::move(mesh_);
  }

 private:
  // Material on one side only of a stretch of sector line: the region ends there.
  void add_line_outline(int line) {
    const std::vector<LinePoint>& points = lines_[line];
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].inside_before == points[i].inside_after) continue;
      const std::uint32_t low = first_on_line_[line] + i;
      add_outline({low, low + 1, points[i].inside_before, points[i].inside_after,
                   origin_on_line(region_, line, points[i].z, points[i + 1].z)});
    }
  }

  // Turned so that there is material on the left.
  void add_outline(OutlineEdge edge) {
    if (edge.left == 0) {
      std::swap(edge.from, edge.to);
      std::swap(edge.left, edge.right);
    }
    mesh_.outline.push_back(edge);
  }

  void add_sector(int sector) {
    const std::vector<RegionEdge>& edges = region_.sectors[sector];
    interior_.clear();
    for (const RegionEdge& edge : edges) {
      for (const GridPoint point : {edge.a, edge.b}) {
        if (point.u != 0 && point.u != region_.grid.sector_steps) interior_.push_back(point);
      }
    }
    std::sort(interior_.begin(), interior_.end());
    interior_.erase(std::unique(interior_.begin(), interior_.end()), interior_.end());
    first_interior_ = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (const GridPoint point : interior_) mesh_.vertices.push_back({sector, point});

    std::vector<SectorEdge> bounds = sector_edges(sector);
    if (!bounds.empty()) add_triangles(sector, std::move(bounds));
  }

  std::vector<SectorEdge> sector_edges(int sector) {
    std::vector<SectorEdge> bounds;
    for (const RegionEdge& edge : region_.sectors[sector]) {
      const std::uint32_t a = index_of(sector, edge.a);
      const std::uint32_t b = index_of(sector, edge.b);
      bounds.push_back({a, b, edge.inside_left, edge.inside_right});
      if (edge.is_outline()) {
        add_outline({a, b, edge.inside_left, edge.inside_right, edge.origin});
      }
    }
    const int next = (sector + 1) % region_.grid.sectors;
    for (std::uint32_t i = 0; i + 1 < lines_[sector].size(); ++i) {
      const std::uint32_t low = first_on_line_[sector] + i;
      const Layers inside = lines_[sector][i].inside_after;
      if (inside != 0) bounds.push_back({low + 1, low, inside, 0});
    }
    for (std::uint32_t i = 0; i + 1 < lines_[next].size(); ++i) {
      const std::uint32_t low = first_on_line_[next] + i;
      const Layers inside = lines_[next][i].inside_before;
      if (inside != 0) bounds.push_back({low, low + 1, inside, 0});
    }
    return bounds;
  }

  std::uint32_t index_of(int sector, GridPoint point) const {
    if (point.u == 0) return on_line(sector, point.z);
    if (point.u == region_.grid.sector_steps) {
      return on_line((sector + 1) % region_.grid.sectors, point.z);
    }
    const auto at = std::lower_bound(interior_.begin(), interior_.end(), point);
    return first_interior_ + static_cast<std::uint32_t>(at - interior_.begin());
  }

  std::uint32_t on_line(int line, std::int32_t z) const {
    const auto at =
        std::lower_bound(lines_[line].begin(), lines_[line].end(), z,
                         [](const LinePoint& p, std::int32_t value) { return p.z < value; });
    return first_on_line_[line] + static_cast<std::uint32_t>(at - lines_[line].begin());
  }

  // A region vertex as seen from a sector: one on the next line lies at the sector's right side.
  GridPoint position(int sector, std::uint32_t vertex) const {
    const PlaneMeshVertex& v = mesh_.vertices[vertex];
    const bool on_left =
        v.sector == sector && vertex < first_on_line_[sector] + lines_[sector].size();
    if (on_left || vertex >= first_interior_) return v.point;
    return {region_.grid.sector_steps, v.point.z};
  }

  void add_triangles(int sector, std::vector<SectorEdge> bounds) {
    numbers_.clear();
    for (const SectorEdge& edge : bounds) numbers_.insert(numbers_.end(), {edge.from, edge.to});
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());

    std::vector<GridPoint> points;
    points.reserve(numbers_.size());
    for (const std::uint32_t number : numbers_) points.push_back(position(sector, number));
    for (SectorEdge& edge : bounds) {
      edge.from = place_of(edge.from);
      edge.to = place_of(edge.to);
    }
    for (const SectorTriangle& triangle : triangulate_sector(points, bounds)) {
      const auto& [a, b, c] = triangle.corners;
      mesh_.triangles.push_back({numbers_[a], numbers_[b], numbers_[c]});
      mesh_.layers.push_back(triangle.layers);
    }
  }

  // Where a vertex stands among the sector's.
  std::uint32_t place_of(std::uint32_t number) const {
    const auto at = std::lower_bound(numbers_.begin(), numbers_.end(), number);
    return static_cast<std::uint32_t>(at - numbers_.begin());
  }

  const Region& region_;
  PlaneMesh mesh_;
  std::vector<std::vector<LinePoint>> lines_;
  std::vector<std::uint32_t> first_on_line_;
  std::vector<GridPoint> interior_;
  std::vector<std::uint32_t> numbers_;  // the sector's vertices by number, ascending
  std::uint32_t first_interior_ = 0;
};

}  // namespace

PlaneMesh triangulate(const Region& region) {
  return Builder(region).run();
}

int pieces(const PlaneMesh& mesh) {
  DisjointSets connected(mesh.vertices.size());
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      used[vertex] = 1;
      connected.join(vertex, triangle[0]);
    }
  }
  int count = 0;
  for (std::uint32_t i = 0; i < used.size(); ++i) count += used[i] && connected.root(i) == i;
  return count;
}

}  // namespace latticast
