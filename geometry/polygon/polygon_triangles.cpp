// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

namespace latticast {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlanePoint = Kernel::Point_2;

struct FaceState {
  int winding = 0;
  bool seen = false;
};

using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceState, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Of twice the area, by Newell's sum over the sides; not finite where a coordinate is not.
Point normal_of(std::span<const Point> corners) {
  Point normal{};
  const Point& origin = corners.front();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[i + 1 == corners.size() ? 0 : i + 1];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      normal[axis] +=
          (a[u] - origin[u]) * (b[v] - origin[v]) - (a[v] - origin[v]) * (b[u] - origin[u]);
    }
  }
  return normal;
}

/// The corners seen along the axis nearest to the normal, counter-clockwise; empty where there is
/// no plane. Leaving out a coordinate rounds nothing: what is straight stays so.
std::vector<PlanePoint> seen_flat(std::span<const Point> corners) {
  const Point normal = normal_of(corners);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  if (!(std::abs(normal[axis]) > 0) || !std::isfinite(normal[0] + normal[1] + normal[2])) return {};
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<PlanePoint> flat;
  flat.reserve(corners.size());
  for (const Point& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

// Turning left at every corner, once around: the x coordinate changes its direction twice.
bool is_strictly_convex(const std::vector<PlanePoint>& corners) {
  const std::size_t count = corners.size();
  int changes = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlanePoint& a = corners[i];
    const PlanePoint& b = corners[(i + 1) % count];
    const PlanePoint& c = corners[(i + 2) % count];
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return false;
    changes += CGAL::compare_xy(a, b) != CGAL::compare_xy(b, c);
  }
  return changes == 2;
}

// As deep as the logarithm of the corners' number, and no corner has more triangles than that.
void halve(std::uint32_t first, std::uint32_t last, std::vector<Triangle>& triangles) {
  if (last - first < 2) return;
  const std::uint32_t middle = first + (last - first + 1) / 2;
  halve(first, middle, triangles);
  triangles.push_back({first, middle, last});
  halve(middle, last, triangles);
}

std::vector<Triangle> halved(std::size_t count) {
  std::vector<Triangle> triangles;
  triangles.reserve(count - 2);
  halve(0, static_cast<std::uint32_t>(count - 1), triangles);
  return triangles;
}

class Inside {
 public:
  /// Throws Triangulation::Intersection_of_constraints_exception for sides that cross.
  std::vector<Triangle> triangles(const std::vector<PlanePoint>& corners) {
    insert(corners);
    spread();
    std::vector<Triangle> inside;
    for (const auto& face : triangulation_.finite_face_handles()) {
      if (face->info().winding <= 0) continue;
      inside.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return inside;
  }

  bool joins_corners_in(std::span<const Point> corners) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (corners[vertices_[i]->info()] != corners[i]) return true;
    }
    return false;
  }

 private:
  using VertexHandle = Triangulation::Vertex_handle;
  using FaceHandle = Triangulation::Face_handle;
  using Corner = std::pair<PlanePoint, std::uint32_t>;

  // In the order of the outline, each corner of a comb would flip the edges of all before it.
  static std::vector<Corner> spread_out(const std::vector<PlanePoint>& corners) {
    std::vector<Corner> order;
    order.reserve(corners.size());
    for (const PlanePoint& corner : corners) {
      order.emplace_back(corner, static_cast<std::uint32_t>(order.size()));
    }
    using Traits =
        CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Corner>>;
    CGAL::spatial_sort(order.begin(), order.end(), Traits());
    return order;
  }

  void insert(const std::vector<PlanePoint>& corners) {
    vertices_.resize(corners.size());
    FaceHandle near;
    for (const auto& [corner, i] : spread_out(corners)) {
      const std::size_t before = triangulation_.number_of_vertices();
      const VertexHandle vertex = triangulation_.insert(corner, near);
      if (triangulation_.number_of_vertices() > before) vertex->info() = i;
      vertices_[i] = vertex;
      near = vertex->face();
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexHandle from = vertices_[i];
      const VertexHandle to = vertices_[i + 1 == corners.size() ? 0 : i + 1];
      if (from != to) triangulation_.insert_constraint(from, to);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      count_side(vertices_[i], vertices_[i + 1 == corners.size() ? 0 : i + 1]);
    }
  }

  // A side that passes through other corners is several edges.
  void count_side(VertexHandle from, const VertexHandle& to) {
    while (from != to) {
      VertexHandle next;
      FaceHandle face;
      int edge = 0;
      if (!triangulation_.includes_edge(from, to, next, face, edge)) return;
      ++sides_[{from->info(), next->info()}];
      from = next;
    }
  }

  // How often the polygon runs from one corner to the next, less how often back.
  int sides(const VertexHandle& from, const VertexHandle& to) const {
    const auto count = [&](std::uint32_t a, std::uint32_t b) {
      const auto found = sides_.find({a, b});
      return found == sides_.end() ? 0 : found->second;
    };
    return count(from->info(), to->info()) - count(to->info(), from->info());
  }

  // The winding number of each face, from the outside inwards.
  void spread() {
    std::vector<FaceHandle> waiting{triangulation_.infinite_face()};
    waiting.front()->info().seen = true;
    while (!waiting.empty()) {
      const FaceHandle face = waiting.back();
      waiting.pop_back();
      for (int i = 0; i < 3; ++i) {
        const FaceHandle beyond = face->neighbor(i);
        if (beyond->info().seen) continue;
        const VertexHandle from = face->vertex(Triangulation::ccw(i));
        const VertexHandle to = face->vertex(Triangulation::cw(i));
        // `face` lies on the left of from -> to.
        const bool is_side = triangulation_.is_constrained({face, i});
        beyond->info() = {face->info().winding - (is_side ? sides(from, to) : 0), true};
        waiting.push_back(beyond);
      }
    }
  }

  Triangulation triangulation_;
  std::vector<VertexHandle> vertices_;  // of the corners
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides_;
};

std::vector<Triangle> constrained(std::span<const Point> corners,
                                  const std::vector<PlanePoint>& flat) {
  try {
    Inside inside;
    std::vector<Triangle> triangles = inside.triangles(flat);
    if (!inside.joins_corners_in(corners)) return triangles;
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    // as below
  }
  return {};
}

}  // namespace

std::vector<Triangle> polygon_triangles(std::span<const Point> corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  const std::vector<PlanePoint> flat = seen_flat(corners);
  if (!flat.empty() && !is_strictly_convex(flat)) {
    std::vector<Triangle> triangles = constrained(corners, flat);
    if (!triangles.empty()) return triangles;
  }
  return halved(corners.size());
}

}  // namespace latticast
