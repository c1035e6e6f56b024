// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_mesh.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/exact_kernel.h"

namespace latticast {
namespace {

constexpr double safe_height_steps = 1;
constexpr int most_flip_passes = 100;

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, ExactKernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<
    bool, ExactKernel, CGAL::Constrained_triangulation_face_base_2<ExactKernel>>;
using Cells = CGAL::Constrained_Delaunay_triangulation_2<
    ExactKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

// An edge of one sector by vertex number, and what of this sector is material beside it.
struct SectorEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Layers left = 0;
  Layers right = 0;
};

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

    const std::vector<SectorEdge> bounds = sector_edges(sector);
    if (!bounds.empty()) triangulate_sector(sector, bounds);
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
  ExactKernel::Point_2 position(int sector, std::uint32_t vertex) const {
    const PlaneMeshVertex& v = mesh_.vertices[vertex];
    const bool on_left =
        v.sector == sector && vertex < first_on_line_[sector] + lines_[sector].size();
    if (on_left || vertex >= first_interior_) {
      return {static_cast<double>(v.point.u), static_cast<double>(v.point.z)};
    }
    return {static_cast<double>(region_.grid.sector_steps), static_cast<double>(v.point.z)};
  }

  void triangulate_sector(int sector, const std::vector<SectorEdge>& bounds) {
    numbers_.clear();
    for (const SectorEdge& edge : bounds) numbers_.insert(numbers_.end(), {edge.from, edge.to});
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());

    std::vector<std::pair<ExactKernel::Point_2, std::uint32_t>> points;
    points.reserve(numbers_.size());
    for (std::uint32_t i = 0; i < numbers_.size(); ++i) {
      points.emplace_back(position(sector, numbers_[i]), i);
    }
    Cells cells;
    cells.insert(points.begin(), points.end());
    std::vector<Cells::Vertex_handle> handles(numbers_.size());
    for (const auto vertex : cells.finite_vertex_handles()) handles[vertex->info()] = vertex;

    const auto handle_of = [&](std::uint32_t vertex) {
      return handles[std::lower_bound(numbers_.begin(), numbers_.end(), vertex) - numbers_.begin()];
    };
    for (const SectorEdge& edge : bounds) {
      cells.insert_constraint(handle_of(edge.from), handle_of(edge.to));
    }
    raise_low_triangles(cells);
    for (const auto face : cells.all_face_handles()) face->info() = false;
    for (const SectorEdge& edge : bounds) {
      if (edge.left != 0) fill_from(cells, handle_of(edge.from), handle_of(edge.to), edge.left);
      if (edge.right != 0) fill_from(cells, handle_of(edge.to), handle_of(edge.from), edge.right);
    }
  }

  // A vertex lies at least one step from every edge that is not its own, but may lie far closer to
  // a Delaunay diagonal, closer even than float32 can tell: rounded, that triangle would turn over.
  // Flipping the diagonal parts the two; each flip makes the lower of two triangles higher.
  static void raise_low_triangles(Cells& cells) {
    bool changed = true;
    for (int pass = 0; changed && pass < most_flip_passes; ++pass) {
      changed = false;
      for (const auto& found : cells.finite_face_handles()) {
        if (height(corner(found, 0), corner(found, 1), corner(found, 2)) >= safe_height_steps) {
          continue;
        }
        for (int i = 0; i < 3; ++i) {
          Cells::Face_handle face = found;
          if (!flip_is_better(cells, face, i)) continue;
          cells.flip(face, i);
          changed = true;
          break;
        }
      }
    }
  }

  static GridPoint corner(Cells::Face_handle face, int i) {
    const auto& p = face->vertex(i)->point();
    return {static_cast<std::int32_t>(p.x()), static_cast<std::int32_t>(p.y())};
  }

  // Least distance of a corner from the line through the two others; not positive for a triangle
  // that is not counter-clockwise.
  static double height(GridPoint a, GridPoint b, GridPoint c) {
    const auto length = [](GridPoint p, GridPoint q) {
      return std::hypot(static_cast<double>(q.u) - p.u, static_cast<double>(q.z) - p.z);
    };
    return static_cast<double>(turn(a, b, c)) /
           std::max({length(a, b), length(b, c), length(c, a)});
  }

  static bool flip_is_better(const Cells& cells, Cells::Face_handle face, int i) {
    const Cells::Face_handle other = face->neighbor(i);
    if (face->is_constrained(i) || cells.is_infinite(other)) return false;
    const GridPoint apex = corner(face, i);
    const GridPoint from = corner(face, Cells::ccw(i));
    const GridPoint to = corner(face, Cells::cw(i));
    const GridPoint opposite = corner(other, cells.mirror_index(face, i));
    const double before = std::min(height(apex, from, to), height(opposite, to, from));
    const double after = std::min(height(apex, from, opposite), height(opposite, to, apex));
    return after > before;
  }

  // Adds the material that lies on the left of an edge and has not been reached yet.
  void fill_from(Cells& cells, Cells::Vertex_handle from, Cells::Vertex_handle to, Layers layers) {
    Cells::Face_handle face;
    int side = 0;
    // The face found lies on the edge's left: is_edge gives it with from = cw(side), so turned
    // around.
    cells.is_edge(to, from, face, side);
    if (face->vertex(Cells::ccw(side)) != from) face = face->neighbor(side);
    std::vector<Cells::Face_handle> pending{face};
    while (!pending.empty()) {
      face = pending.back();
      pending.pop_back();
      if (face->info()) continue;
      face->info() = true;
      mesh_.triangles.push_back({numbers_[face->vertex(0)->info()],
                                 numbers_[face->vertex(1)->info()],
                                 numbers_[face->vertex(2)->info()]});
      mesh_.layers.push_back(layers);
      for (int i = 0; i < 3; ++i) {
        if (!face->is_constrained(i)) pending.push_back(face->neighbor(i));
      }
    }
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
