// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <unordered_map>

#include "geometry/mesh/disjoint_sets.h"

namespace latticast {
namespace {

constexpr int fewest_sectors = 12;
constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

double corner_factor(double sector_angle) {
  return std::sqrt(sector_angle / std::sin(sector_angle));
}

std::uint64_t edge_key(const std::array<std::uint32_t, 3>& triangle, int side) {
  const std::uint64_t a = triangle[side];
  const std::uint64_t b = triangle[(side + 1) % 3];
  return (std::min(a, b) << 32U) | std::max(a, b);
}

// Makes the mesh vertices of plane vertices at radii on demand, and the faces between them.
class Wrapper {
 public:
  explicit Wrapper(const Relief& relief) : relief_(relief), grid_(relief.plane.grid) {
    const double angle = grid_.sector_angle_rad();
    for (int line = 0; line <= grid_.sectors; ++line) {
      const int around = line % grid_.sectors;
      directions_.push_back({std::cos(around * angle), std::sin(around * angle)});
    }
    for (const std::vector<double>& radii : relief.radii_mm) {
      first_level_.push_back(corner_radii_.empty() ? 0 : corner_radii_.size() - 1);
      for (std::size_t i = corner_radii_.empty() ? 0 : 1; i < radii.size(); ++i) {
        corner_radii_.push_back(radii[i] * corner_factor(angle));
      }
    }
    first_level_.push_back(corner_radii_.size() - 1);
    vertex_at_.assign(relief.plane.vertices.size() * corner_radii_.size(), unused);
  }

  TriangleMesh run() {
    for (std::size_t i = 0; i < relief_.plane.triangles.size(); ++i) {
      add_floors_and_ceilings(relief_.plane.triangles[i], relief_.plane.layers[i]);
    }
    for (const OutlineEdge& edge : relief_.plane.outline) add_walls(edge);
    return std::move(mesh_);
  }

 private:
  std::size_t layer_count() const { return first_level_.size() - 1; }

  // A layer under another one, or on one, has no face there; nor has the axis.
  void add_floors_and_ceilings(const std::array<std::uint32_t, 3>& triangle, Layers layers) {
    const auto [a, b, c] = triangle;
    for (std::size_t layer = 0; layer < layer_count(); ++layer) {
      if (!has(layers, layer)) continue;
      const std::size_t bottom = first_level_[layer];
      const std::size_t top = first_level_[layer + 1];
      if (layer + 1 == layer_count() || !has(layers, layer + 1)) {
        mesh_.triangles.push_back({vertex(a, top), vertex(b, top), vertex(c, top)});
      }
      if (!on_axis(bottom) && (layer == 0 || !has(layers, layer - 1))) {
        mesh_.triangles.push_back({vertex(a, bottom), vertex(c, bottom), vertex(b, bottom)});
      }
    }
  }

  bool on_axis(std::size_t level) const { return corner_radii_[level] == 0; }

  void add_walls(const OutlineEdge& edge) {
    for (std::size_t layer = 0; layer < layer_count(); ++layer) {
      if (has(edge.left, layer) == has(edge.right, layer)) continue;
      const bool forward = has(edge.left, layer);
      for (std::size_t level = first_level_[layer]; level < first_level_[layer + 1]; ++level) {
        add_wall(forward ? edge.from : edge.to, forward ? edge.to : edge.from, level);
      }
    }
  }

  // The wall under an outline edge with the material on its left, between two neighbouring radii.
  void add_wall(std::uint32_t from, std::uint32_t to, std::size_t level) {
    if (on_axis(level)) {
      mesh_.triangles.push_back(
          {vertex(from, level), vertex(to, level + 1), vertex(from, level + 1)});
      return;
    }
    const std::array<std::uint32_t, 4> corners{vertex(from, level), vertex(to, level),
                                               vertex(to, level + 1), vertex(from, level + 1)};
    if (is_flat(from, to)) {
      mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
      mesh_.triangles.push_back({corners[0], corners[2], corners[3]});
      return;
    }
    const std::uint32_t middle = add_middle(corners);
    for (int i = 0; i < 4; ++i) {
      mesh_.triangles.push_back({corners[i], corners[(i + 1) % 4], middle});
    }
  }

  // Walls along the tube lie in a plane through its axis direction, walls around it in a
  // cross-section.
  bool is_flat(std::uint32_t from, std::uint32_t to) const {
    const PlaneMeshVertex& a = relief_.plane.vertices[from];
    const PlaneMeshVertex& b = relief_.plane.vertices[to];
    return a.point.z == b.point.z || (a.sector == b.sector && a.point.u == b.point.u);
  }

  std::uint32_t add_middle(const std::array<std::uint32_t, 4>& corners) {
    Point middle{};
    for (const std::uint32_t corner : corners) {
      for (int axis = 0; axis < 3; ++axis) middle[axis] += 0.25 * mesh_.vertices[corner][axis];
    }
    mesh_.vertices.push_back(middle);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  std::uint32_t vertex(std::uint32_t plane_vertex, std::size_t level) {
    std::uint32_t& index = on_axis(level)
                               ? axis_vertex_.try_emplace(z_of(plane_vertex), unused).first->second
                               : vertex_at_[plane_vertex * corner_radii_.size() + level];
    if (index == unused) {
      index = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back(
          position(relief_.plane.vertices[plane_vertex], corner_radii_[level]));
    }
    return index;
  }

  std::int32_t z_of(std::uint32_t plane_vertex) const {
    return relief_.plane.vertices[plane_vertex].point.z;
  }

  // On the chord between the sector's two corner lines.
  Point position(const PlaneMeshVertex& v, double radius) const {
    const double part = static_cast<double>(v.point.u) / grid_.sector_steps;
    const auto& left = directions_[v.sector];
    const auto& right = directions_[v.sector + 1];
    return {radius * std::lerp(left[0], right[0], part),
            radius * std::lerp(left[1], right[1], part),
            relief_.start_z_mm + v.point.z * grid_.z_step_mm};
  }

  const Relief& relief_;
  const PlaneGrid& grid_;
  std::vector<std::array<double, 2>>
      directions_;                        // of the sector lines; the last is the first again
  std::vector<double> corner_radii_;      // of all levels
  std::vector<std::size_t> first_level_;  // of each layer, and the last level of all
  std::vector<std::uint32_t> vertex_at_;  // mesh vertex of (plane vertex, level)
  std::map<std::int32_t, std::uint32_t> axis_vertex_;  // mesh vertex on the axis, by z
  TriangleMesh mesh_;
};

// Pairs of triangles that have all of `layers` and an edge in common.
template <class Visit>
void for_each_shared_edge(const PlaneMesh& plane, Layers layers, Visit&& visit) {
  std::unordered_map<std::uint64_t, std::size_t> first;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
    if ((plane.layers[i] & layers) != layers) continue;
    for (int side = 0; side < 3; ++side) {
      const auto [known, is_new] = first.try_emplace(edge_key(plane.triangles[i], side), i);
      if (!is_new) visit(known->second, i);
    }
  }
}

// Of the closed region in which all of `layers` are material: corners - edges + triangles.
int euler_characteristic(const PlaneMesh& plane, Layers layers) {
  std::vector<char> used(plane.vertices.size(), 0);
  int triangles = 0;
  int shared = 0;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
    if ((plane.layers[i] & layers) != layers) continue;
    ++triangles;
    for (const std::uint32_t corner : plane.triangles[i]) used[corner] = 1;
  }
  for_each_shared_edge(plane, layers, [&](std::size_t, std::size_t) { ++shared; });
  const auto corners = static_cast<int>(std::count(used.begin(), used.end(), 1));
  return corners - (3 * triangles - shared) + triangles;
}

// Connected parts of layer 0.
int parts_of_first_layer(const PlaneMesh& plane) {
  PlaneMesh alone;
  alone.vertices = plane.vertices;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
    if ((plane.layers[i] & 1U) != 0) alone.triangles.push_back(plane.triangles[i]);
  }
  return pieces(alone);
}

}  // namespace

ReliefTopology topology(const Relief& relief) {
  const PlaneMesh& plane = relief.plane;
  const auto layers = static_cast<int>(relief.radii_mm.size());
  // Cells are triangles of one layer; the solid's pieces join across edges and between layers.
  const std::size_t triangles = plane.triangles.size();
  DisjointSets joined_cells(triangles * layers);
  const auto cell = [&](std::size_t triangle, int layer) {
    return static_cast<std::uint32_t>(triangle + layer * triangles);
  };
  int characteristic = 0;
  int cells = 0;
  int joined = 0;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (joined_cells.join(a, b)) ++joined;
  };
  for (int layer = 0; layer < layers; ++layer) {
    const Layers here = Layers{1} << layer;
    characteristic += euler_characteristic(plane, here);
    // A band around the axis, of characteristic 0, is closed by it to a disc.
    if (relief.radii_mm[layer].front() == 0) characteristic += parts_of_first_layer(plane);
    for_each_shared_edge(
        plane, here, [&](std::size_t a, std::size_t b) { join(cell(a, layer), cell(b, layer)); });
    for (std::size_t i = 0; i < triangles; ++i) cells += (plane.layers[i] & here) != 0 ? 1 : 0;
    if (layer + 1 == layers) continue;
    const Layers both = here | (here << 1);
    characteristic -= euler_characteristic(plane, both);
    for (std::size_t i = 0; i < triangles; ++i) {
      if ((plane.layers[i] & both) == both) join(cell(i, layer), cell(i, layer + 1));
    }
  }
  const int pieces = cells - joined;
  return {pieces, pieces - characteristic};
}

TriangleMesh wrap(const Relief& relief) {
  return Wrapper(relief).run();
}

double chord_error_mm(double radius_mm, double sector_angle_rad) {
  const double factor = corner_factor(sector_angle_rad);
  return radius_mm * std::max(factor - 1, 1 - factor * std::cos(0.5 * sector_angle_rad));
}

double wall_error_mm(double depth_mm, double sector_angle_rad, double steepness) {
  // A wall's middle vertex leaves the ruled surface by 1/16 of the difference between its outer and
  // inner edge, which is the sector's angle times the wall's depth; square to the wall, times
  // steepness.
  return sector_angle_rad * depth_mm * steepness / 16;
}

int sectors_for(double radius_mm, double tolerance_mm) {
  // factor - 1 = D^2/12 + O(D^4), so this first guess is at most a few sectors off.
  const double angle = std::sqrt(12 * tolerance_mm / radius_mm);
  int sectors = std::max(fewest_sectors, static_cast<int>(2 * std::numbers::pi / angle));
  while (chord_error_mm(radius_mm, 2 * std::numbers::pi / sectors) > tolerance_mm) ++sectors;
  return sectors;
}

std::vector<double> wall_radii(double floor_mm, double ceiling_mm, double sector_angle_rad,
                               double steepness, double tolerance_mm) {
  const double off = wall_error_mm(ceiling_mm - floor_mm, sector_angle_rad, steepness);
  const int layers = std::max(1, static_cast<int>(std::ceil(off / tolerance_mm - 1e-9)));
  std::vector<double> radii(layers + 1);
  for (int i = 0; i <= layers; ++i) radii[i] = std::lerp(floor_mm, ceiling_mm, double(i) / layers);
  return radii;
}

}  // namespace latticast
