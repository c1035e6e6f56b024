// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/plane_mesh.h"

namespace latticast {
namespace {

constexpr int sectors_around = 48;
constexpr double closing_mm = 0.01;
constexpr double level_mm = 0.05;
constexpr double nearly_whole_turn = 0.9;  // a plateau that reaches this far around is a ring

// What a bore may be, and how it sits in its strand.
struct BoreKind {
  double largest_radius_mm = 0;
  double share = 0;      // of the distance to the strand's sides
  double direction = 0;  // +1: as high as possible, -1: as low
};
constexpr BoreKind vent{0.75, 0.6, 1};
constexpr BoreKind sprue{2, 0.9, -1};

struct Plateau {
  std::vector<std::uint32_t> vertices;
  double from_u = 0;
  double to_u = 0;
  double z = 0;
};

// The united strands as a surface with heights.
class Cavity {
 public:
  explicit Cavity(const Pattern& strands)
      : circumference_(strands.circumference_mm),
        region_(unite(strands,
                      make_plane_grid(strands.circumference_mm, strands.length_mm, sectors_around),
                      {}, closing_mm)),
        mesh_(triangulate(region_)) {
    for (const PlaneMeshVertex& v : mesh_.vertices) {
      const double steps = static_cast<double>(v.sector) * mesh_.grid.sector_steps + v.point.u;
      points_.push_back({steps * mesh_.grid.u_step_mm, v.point.z * mesh_.grid.z_step_mm});
    }
    triangles_at_.resize(points_.size());
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (const std::uint32_t corner : mesh_.triangles[i]) triangles_at_[corner].push_back(i);
    }
  }

  double area() const { return area_mm2(region_); }

  // Every separate part's vertex that is furthest in the direction, and every other one from which
  // there is no way further without going back by more than `level_mm`.
  std::vector<std::uint32_t> extremes(double direction, bool one_a_part) const;
  Plateau plateau_of(std::uint32_t extreme) const;
  Bore bore_at(const Plateau& plateau, double u, const BoreKind& kind) const;
  double circumference() const { return circumference_; }

 private:
  double beside(double u, double v) const { return std::remainder(u - v, circumference_); }

  template <class Visit>
  void for_each_neighbour(std::uint32_t vertex, Visit&& visit) const {
    for (const std::uint32_t triangle : triangles_at_[vertex]) {
      for (const std::uint32_t corner : mesh_.triangles[triangle]) {
        if (corner != vertex) visit(corner);
      }
    }
  }

  std::vector<std::uint32_t> triangles_around(const Plateau& plateau, double u, double reach) const;
  std::vector<PlanePoint> places_around(const Plateau& plateau, double u, double reach) const;
  std::vector<OutlineEdge> outline_around(PlanePoint middle, double reach) const;
  double clearance(PlanePoint place, const std::vector<OutlineEdge>& edges) const;

  double circumference_ = 0;
  Region region_;
  PlaneMesh mesh_;
  std::vector<PlanePoint> points_;
  std::vector<std::vector<std::uint32_t>> triangles_at_;
};

// Vertices join in the order of their height, as water falls from them: where two parts meet, the
// lower top counts only if it stands out.
std::vector<std::uint32_t> Cavity::extremes(double direction, bool one_a_part) const {
  const auto height = [&](std::uint32_t v) { return direction * points_[v].z; };
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (!triangles_at_[v].empty()) order.push_back(v);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return height(a) > height(b); });
  DisjointSets parts(points_.size());
  std::vector<char> reached(points_.size(), 0);
  std::vector<std::uint32_t> found;
  for (const std::uint32_t v : order) {
    reached[v] = 1;
    for_each_neighbour(v, [&](std::uint32_t other) {
      if (!reached[other]) return;
      // A root is its part's top.
      std::uint32_t low = parts.root(v);
      std::uint32_t high = parts.root(other);
      if (low == high) return;
      if (height(low) > height(high)) std::swap(low, high);
      if (!one_a_part && height(low) - height(v) > level_mm) found.push_back(low);
      parts.join(low, high);
    });
  }
  for (const std::uint32_t v : order) {
    if (parts.root(v) == v) found.push_back(v);
  }
  return found;
}

Plateau Cavity::plateau_of(std::uint32_t extreme) const {
  Plateau plateau;
  plateau.z = points_[extreme].z;
  std::vector<char> seen(points_.size(), 0);
  std::vector<std::pair<std::uint32_t, double>> pending{{extreme, points_[extreme].u}};
  seen[extreme] = 1;
  plateau.from_u = plateau.to_u = points_[extreme].u;
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const auto [vertex, u] = pending[i];
    plateau.vertices.push_back(vertex);
    plateau.from_u = std::min(plateau.from_u, u);
    plateau.to_u = std::max(plateau.to_u, u);
    for_each_neighbour(vertex, [&, at = u, from = vertex](std::uint32_t other) {
      if (seen[other] || std::abs(points_[other].z - plateau.z) > level_mm) return;
      seen[other] = 1;
      pending.emplace_back(other, at + beside(points_[other].u, points_[from].u));
    });
  }
  return plateau;
}

// Those that can be reached from the plateau's part near u without going further away than `reach`.
std::vector<std::uint32_t> Cavity::triangles_around(const Plateau& plateau, double u,
                                                    double reach) const {
  std::uint32_t nearest = plateau.vertices.front();
  for (const std::uint32_t v : plateau.vertices) {
    if (std::abs(beside(points_[v].u, u)) < std::abs(beside(points_[nearest].u, u))) nearest = v;
  }
  std::vector<std::uint32_t> pending{nearest};
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> seen{nearest};
  while (!pending.empty()) {
    const std::uint32_t vertex = pending.back();
    pending.pop_back();
    found.insert(found.end(), triangles_at_[vertex].begin(), triangles_at_[vertex].end());
    for_each_neighbour(vertex, [&](std::uint32_t other) {
      if (std::abs(beside(points_[other].u, u)) > reach) return;
      if (std::abs(points_[other].z - plateau.z) > reach) return;
      if (std::find(seen.begin(), seen.end(), other) != seen.end()) return;
      seen.push_back(other);
      pending.push_back(other);
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Points of a fine lattice inside of the triangles around.
std::vector<PlanePoint> Cavity::places_around(const Plateau& plateau, double u,
                                              double reach) const {
  const double step = reach / 16;
  std::vector<PlanePoint> places;
  for (const std::uint32_t i : triangles_around(plateau, u, reach)) {
    std::array<PlanePoint, 3> p;
    for (int k = 0; k < 3; ++k) {
      const PlanePoint& corner = points_[mesh_.triangles[i][k]];
      p[k] = {beside(corner.u, u), corner.z - plateau.z};
    }
    const auto [left, right] = std::minmax({p[0].u, p[1].u, p[2].u});
    const auto [low, high] = std::minmax({p[0].z, p[1].z, p[2].z});
    const auto first = [&](double from) {
      return static_cast<int>(std::ceil(std::max(from, -reach) / step));
    };
    const auto last = [&](double to) {
      return static_cast<int>(std::floor(std::min(to, reach) / step));
    };
    for (int across = first(left); across <= last(right); ++across) {
      for (int up = first(low); up <= last(high); ++up) {
        const double x = across * step;
        const double z = up * step;
        const auto left_of = [&](const PlanePoint& a, const PlanePoint& b) {
          return (b.u - a.u) * (z - a.z) - (b.z - a.z) * (x - a.u) >= 0;
        };
        if (left_of(p[0], p[1]) && left_of(p[1], p[2]) && left_of(p[2], p[0])) {
          places.push_back({u + x, plateau.z + z});
        }
      }
    }
  }
  return places;
}

std::vector<OutlineEdge> Cavity::outline_around(PlanePoint middle, double reach) const {
  std::vector<OutlineEdge> near;
  for (const OutlineEdge& edge : mesh_.outline) {
    const PlanePoint& a = points_[edge.from];
    const PlanePoint& b = points_[edge.to];
    if (std::min(a.z, b.z) > middle.z + reach || std::max(a.z, b.z) < middle.z - reach) continue;
    const double length = std::abs(beside(a.u, b.u));
    if (std::abs(beside(a.u, middle.u)) <= reach + length) near.push_back(edge);
  }
  return near;
}

double Cavity::clearance(PlanePoint place, const std::vector<OutlineEdge>& edges) const {
  double nearest = HUGE_VAL;
  for (const OutlineEdge& edge : edges) {
    const PlanePoint& from = points_[edge.from];
    const PlanePoint& to = points_[edge.to];
    const double du = beside(to.u, from.u);
    const double dz = to.z - from.z;
    const double pu = beside(place.u, from.u);
    const double pz = place.z - from.z;
    const double part = std::clamp((pu * du + pz * dz) / (du * du + dz * dz), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(pu - part * du, pz - part * dz));
  }
  return nearest;
}

// As far in the kind's direction as the bore fits between the strand's sides.
Bore Cavity::bore_at(const Plateau& plateau, double u, const BoreKind& kind) const {
  const double reach = 2 * kind.largest_radius_mm + 0.5;
  const std::vector<PlanePoint> places = places_around(plateau, u, reach);
  const std::vector<OutlineEdge> edges = outline_around({u, plateau.z}, 2 * reach);
  if (places.empty()) return {{u, plateau.z}, 0.1 * kind.largest_radius_mm};
  std::vector<double> room;
  room.reserve(places.size());
  for (const PlanePoint& place : places) room.push_back(clearance(place, edges));
  const double widest = *std::max_element(room.begin(), room.end());
  const double radius = std::min(kind.largest_radius_mm, kind.share * widest);
  std::size_t best = std::max_element(room.begin(), room.end()) - room.begin();
  const auto off = [&](std::size_t i) {
    return std::abs(places[i].z - plateau.z) + 0.5 * std::abs(beside(places[i].u, u));
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (room[i] >= 1.05 * radius && off(i) < off(best)) best = i;
  }
  return {places[best], radius};
}

std::vector<double> vent_places(const Plateau& plateau, const std::vector<double>& around_rad,
                                double circumference, double spacing) {
  std::vector<double> places;
  const double extent = plateau.to_u - plateau.from_u;
  if (extent > nearly_whole_turn * circumference) {
    places.reserve(around_rad.size());
    for (const double angle : around_rad) {
      places.push_back(angle * circumference / (2 * std::numbers::pi));
    }
    return places;
  }
  const int count = std::max(1, static_cast<int>(std::ceil(extent / spacing)));
  places.reserve(count);
  for (int i = 0; i < count; ++i) places.push_back(plateau.from_u + (i + 0.5) * extent / count);
  return places;
}

}  // namespace

FillPlan plan_fill(const Pattern& strands, const FillWish& wish) {
  const Cavity cavity(strands);
  FillPlan plan;
  plan.area_mm2 = cavity.area();
  const auto limited = [&](BoreKind kind) {
    kind.largest_radius_mm = std::min(kind.largest_radius_mm, 0.5 * wish.largest_bore_mm);
    return kind;
  };
  for (const std::uint32_t top : cavity.extremes(vent.direction, false)) {
    const Plateau plateau = cavity.plateau_of(top);
    const std::vector<double> places =
        vent_places(plateau, wish.around_rad, cavity.circumference(), wish.vent_spacing_mm);
    plan.high_points.push_back({0.5 * (plateau.from_u + plateau.to_u), plateau.z});
    for (const double u : places) plan.vents.push_back(cavity.bore_at(plateau, u, limited(vent)));
  }
  for (const std::uint32_t bottom : cavity.extremes(sprue.direction, true)) {
    const Plateau plateau = cavity.plateau_of(bottom);
    const std::vector<double> places =
        vent_places(plateau, wish.around_rad, cavity.circumference(), HUGE_VAL);
    plan.sprues.push_back(cavity.bore_at(plateau, places.front(), limited(sprue)));
    ++plan.cavities;
  }
  return plan;
}

}  // namespace latticast
