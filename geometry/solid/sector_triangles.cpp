// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/sector_triangles.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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

GridPoint corner(Cells::Face_handle face, int i) {
  const auto& p = face->vertex(i)->point();
  return {static_cast<std::int32_t>(p.x()), static_cast<std::int32_t>(p.y())};
}

// Least distance of a corner from the line through the two others; not positive for a triangle
// that is not counter-clockwise.
double height(GridPoint a, GridPoint b, GridPoint c) {
  const auto length = [](GridPoint p, GridPoint q) {
    return std::hypot(static_cast<double>(q.u) - p.u, static_cast<double>(q.z) - p.z);
  };
  return static_cast<double>(turn(a, b, c)) / std::max({length(a, b), length(b, c), length(c, a)});
}

bool flip_is_better(const Cells& cells, Cells::Face_handle face, int i) {
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

// A vertex lies at least one step from every edge that is not its own, but may lie far closer to
// a Delaunay diagonal, closer even than float32 can tell: rounded, that triangle would turn over.
// Flipping the diagonal parts the two; each flip makes the lower of two triangles higher.
void raise_low_triangles(Cells& cells) {
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

// Adds the material that lies on the left of an edge and has not been reached yet.
void fill_from(Cells& cells, Cells::Vertex_handle from, Cells::Vertex_handle to, Layers layers,
               std::vector<SectorTriangle>& triangles) {
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
    triangles.push_back(
        {{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}, layers});
    for (int i = 0; i < 3; ++i) {
      if (!face->is_constrained(i)) pending.push_back(face->neighbor(i));
    }
  }
}

}  // namespace

std::vector<SectorTriangle> triangulate_sector(std::span<const GridPoint> points,
                                               std::span<const SectorEdge> edges) {
  std::vector<std::pair<ExactKernel::Point_2, std::uint32_t>> numbered;
  numbered.reserve(points.size());
  for (const GridPoint point : points) {
    numbered.emplace_back(
        ExactKernel::Point_2(static_cast<double>(point.u), static_cast<double>(point.z)),
        static_cast<std::uint32_t>(numbered.size()));
  }
  Cells cells;
  cells.insert(numbered.begin(), numbered.end());
  std::vector<Cells::Vertex_handle> handles(points.size());
  for (const auto vertex : cells.finite_vertex_handles()) handles[vertex->info()] = vertex;

  for (const SectorEdge& edge : edges) {
    cells.insert_constraint(handles[edge.from], handles[edge.to]);
  }
  raise_low_triangles(cells);
  for (const auto face : cells.all_face_handles()) face->info() = false;
  std::vector<SectorTriangle> triangles;
  for (const SectorEdge& edge : edges) {
    const auto from = handles[edge.from];
    const auto to = handles[edge.to];
    if (edge.left != 0) fill_from(cells, from, to, edge.left, triangles);
    if (edge.right != 0) fill_from(cells, to, from, edge.right, triangles);
  }
  return triangles;
}

}  // namespace latticast
