// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/lattice_plane.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/region.h"

namespace latticast {
namespace {

constexpr double finest_slack_mm = 1e-3;
constexpr double straight_sine = 1e-7;  // grid steps bend a line by less

std::vector<PlanePoint> points_of(const PlaneMesh& mesh) {
  std::vector<PlanePoint> points;
  points.reserve(mesh.vertices.size());
  for (const PlaneMeshVertex& v : mesh.vertices) {
    const double steps = static_cast<double>(v.sector) * mesh.grid.sector_steps + v.point.u;
    points.push_back({steps * mesh.grid.u_step_mm, v.point.z * mesh.grid.z_step_mm});
  }
  return points;
}

// A middle point of a straight stretch turns by less than the grid can tell.
bool is_straight(PlanePoint a, PlanePoint b, PlanePoint c, double step) {
  const double ahead = (b.u - a.u) * (c.u - b.u) + (b.z - a.z) * (c.z - b.z);
  const double reach = std::max(distance(a, b), distance(b, c));
  return ahead > 0 && std::abs(cross(a, b, c)) <= reach * (4 * step + straight_sine * reach);
}

Outline without_straight_points(Outline outline, double step) {
  const std::size_t n = outline.points.size();
  Outline kept{{}, outline.around_mm};
  for (std::size_t i = 0; i < n; ++i) {
    PlanePoint before = outline.points[(i + n - 1) % n];
    PlanePoint after = outline.points[(i + 1) % n];
    if (i == 0) before.u -= outline.around_mm;
    if (i + 1 == n) after.u += outline.around_mm;
    if (!is_straight(before, outline.points[i], after, step)) {
      kept.points.push_back(outline.points[i]);
    }
  }
  if (kept.points.empty()) kept.points.push_back(outline.points.front());
  return kept;
}

// Every vertex of a united region starts exactly one outline edge.
std::vector<Outline> outlines_of(const PlaneMesh& mesh, const std::vector<PlanePoint>& points,
                                 double circumference) {
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> next(points.size(), none);
  for (const OutlineEdge& edge : mesh.outline) next[edge.from] = edge.to;
  std::vector<Outline> outlines;
  for (std::uint32_t first = 0; first < points.size(); ++first) {
    if (next[first] == none) continue;
    Outline outline;
    double u = points[first].u;
    for (std::uint32_t v = first; next[v] != none;) {
      outline.points.push_back({u, points[v].z});
      const std::uint32_t to = next[v];
      u += std::remainder(points[to].u - points[v].u, circumference);
      next[v] = none;
      v = to;
    }
    outline.around_mm = circumference * std::round((u - points[first].u) / circumference);
    outlines.push_back(without_straight_points(std::move(outline),
                                               std::max(mesh.grid.u_step_mm, mesh.grid.z_step_mm)));
  }
  return outlines;
}

std::vector<LatticePart> parts_of(const PlaneMesh& mesh, const std::vector<PlanePoint>& points,
                                  double circumference) {
  DisjointSets connected(points.size());
  for (const auto& t : mesh.triangles) {
    connected.join(t[1], t[0]);
    connected.join(t[2], t[0]);
  }
  std::vector<LatticePart> by_root(points.size());
  std::vector<double> largest(points.size(), 0);
  for (const auto& t : mesh.triangles) {
    PlanePoint corner[3];
    for (int i = 0; i < 3; ++i) {
      corner[i] = points[t[i]];
      corner[i].u = points[t[0]].u + std::remainder(corner[i].u - points[t[0]].u, circumference);
    }
    const double area = 0.5 * cross(corner[0], corner[1], corner[2]);
    LatticePart& part = by_root[connected.root(t[0])];
    part.area_mm2 += area;
    if (area <= largest[connected.root(t[0])]) continue;
    largest[connected.root(t[0])] = area;
    part.place = {(corner[0].u + corner[1].u + corner[2].u) / 3,
                  (corner[0].z + corner[1].z + corner[2].z) / 3};
  }
  std::erase_if(by_root, [](const LatticePart& part) { return part.area_mm2 <= 0; });
  std::stable_sort(by_root.begin(), by_root.end(),
                   [](const auto& a, const auto& b) { return a.area_mm2 > b.area_mm2; });
  return by_root;
}

// How far inside the polygon a point is; negative outside.
double depth_of(PlanePoint p, const std::vector<PlanePoint>& polygon) {
  double nearest = HUGE_VAL;
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const PlanePoint a = polygon[j];
    const PlanePoint b = polygon[i];
    if ((a.z > p.z) != (b.z > p.z) && p.u < a.u + (p.z - a.z) / (b.z - a.z) * (b.u - a.u)) {
      inside = !inside;
    }
    const double length = (b.u - a.u) * (b.u - a.u) + (b.z - a.z) * (b.z - a.z);
    const double along =
        length > 0 ? ((p.u - a.u) * (b.u - a.u) + (p.z - a.z) * (b.z - a.z)) / length : 0;
    const double part = std::clamp(along, 0.0, 1.0);
    nearest = std::min(nearest,
                       std::hypot(p.u - a.u - part * (b.u - a.u), p.z - a.z - part * (b.z - a.z)));
  }
  return inside ? nearest : -nearest;
}

struct Square {
  PlanePoint middle;
  double half = 0;
  double depth = 0;

  double most() const { return depth + half * std::numbers::sqrt2; }
  friend bool operator<(const Square& a, const Square& b) { return a.most() < b.most(); }
};

}  // namespace

bool Outline::is_cell() const {
  if (around_mm != 0) return false;
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    twice_area += cross(points[0], points[i], points[i + 1]);
  }
  return twice_area < 0;
}

LatticePlane lattice_plane(LatticeDrawing& drawing) {
  const PlaneMesh mesh = triangulate(drawing.drawn_union());
  const double circumference = 2 * std::numbers::pi * drawing.segment().lattice_mid_radius_mm();
  LatticePlane plane{circumference, drawing.segment().length_mm, {}, {}, 0};
  const std::vector<PlanePoint> points = points_of(mesh);
  plane.outlines = outlines_of(mesh, points, plane.circumference_mm);
  plane.parts = parts_of(mesh, points, plane.circumference_mm);
  for (const LatticePart& part : plane.parts) plane.area_mm2 += part.area_mm2;
  return plane;
}

// Squares that may hold the middle of a larger circle are quartered, the most promising first.
double inscribed_width_mm(const std::vector<PlanePoint>& polygon, double enough_mm,
                          double slack_mm) {
  if (polygon.size() < 3) return 0;
  PlanePoint low = polygon.front();
  PlanePoint high = low;
  for (const PlanePoint& p : polygon) {
    low = {std::min(low.u, p.u), std::min(low.z, p.z)};
    high = {std::max(high.u, p.u), std::max(high.z, p.z)};
  }
  std::priority_queue<Square> open;
  double best = 0;
  const auto look = [&](PlanePoint middle, double half) {
    const Square square{middle, half, depth_of(middle, polygon)};
    best = std::max(best, square.depth);
    open.push(square);
  };
  look({0.5 * (low.u + high.u), 0.5 * (low.z + high.z)},
       0.5 * std::max(high.u - low.u, high.z - low.z));
  while (!open.empty() && 2 * best <= enough_mm) {
    const Square square = open.top();
    open.pop();
    const double unknown = 2 * (square.most() - best);
    const bool decided = 2 * square.most() <= enough_mm || unknown <= finest_slack_mm;
    if (unknown <= slack_mm && decided) break;
    const double half = 0.5 * square.half;
    for (const double du : {-half, half}) {
      for (const double dz : {-half, half}) {
        look({square.middle.u + du, square.middle.z + dz}, half);
      }
    }
  }
  return 2 * best;
}

}  // namespace latticast
