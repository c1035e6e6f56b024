// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/refined_triangles.h"

#include <cmath>
#include <map>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "geometry/solid/exact_kernel.h"

namespace latticast {
namespace {

// CGAL's bound on sin^2 of the least angle: 20.7 degrees, for which the method ends.
constexpr double squared_sine = 0.125;

struct Number {
  std::uint32_t value = 0xFFFFFFFF;  // of a vertex that is new
  bool is_new() const { return value == 0xFFFFFFFF; }
};

using Numbered =
    CGAL::Triangulation_vertex_base_with_info_2<Number, ExactKernel,
                                                CGAL::Delaunay_mesh_vertex_base_2<ExactKernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    ExactKernel,
    CGAL::Triangulation_data_structure_2<Numbered, CGAL::Delaunay_mesh_face_base_2<ExactKernel>>,
    CGAL::No_constraint_intersection_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Vertex = Triangulation::Vertex_handle;

PlanePoint place(Vertex vertex) {
  return {vertex->point().x(), vertex->point().y()};
}

/// The constrained edge at `from` that leads most directly to `to`.
Vertex next_towards(const Triangulation& triangulation, Vertex from, Vertex to) {
  const PlanePoint a = place(from);
  const PlanePoint b = place(to);
  Vertex best;
  double most = -2;
  std::vector<Triangulation::Edge> edges;
  triangulation.incident_constraints(from, std::back_inserter(edges));
  for (const auto& [face, side] : edges) {
    Vertex other = face->vertex(Triangulation::ccw(side));
    if (other == from) other = face->vertex(Triangulation::cw(side));
    const PlanePoint c = place(other);
    const double along =
        ((c.u - a.u) * (b.u - a.u) + (c.z - a.z) * (b.z - a.z)) / (distance(a, c) * distance(a, b));
    if (along <= most) continue;
    most = along;
    best = other;
  }
  return best;
}

}  // namespace

RefinedTriangles refined_triangles(std::span<const PlanePoint> points,
                                   std::span<const std::array<std::uint32_t, 2>> edges,
                                   double size_mm) {
  Triangulation triangulation;
  std::vector<Vertex> given;
  given.reserve(points.size());
  for (const PlanePoint& point : points) {
    given.push_back(triangulation.insert({point.u, point.z}));
    given.back()->info().value = static_cast<std::uint32_t>(given.size() - 1);
  }
  for (const auto& [from, to] : edges) triangulation.insert_constraint(given[from], given[to]);
  CGAL::refine_Delaunay_mesh_2(triangulation, Criteria(squared_sine, size_mm));

  RefinedTriangles result;
  result.points.assign(points.begin(), points.end());
  for (const Vertex vertex : triangulation.finite_vertex_handles()) {
    if (!vertex->info().is_new()) continue;
    vertex->info().value = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(place(vertex));
  }
  for (const auto face : triangulation.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    result.triangles.push_back({face->vertex(0)->info().value, face->vertex(1)->info().value,
                                face->vertex(2)->info().value});
  }
  for (const auto& [from, to] : edges) {
    std::vector<std::uint32_t>& split = result.edges.emplace_back(1, from);
    for (Vertex at = given[from]; at != given[to];) {
      at = next_towards(triangulation, at, given[to]);
      split.push_back(at->info().value);
    }
  }
  return result;
}

}  // namespace latticast
