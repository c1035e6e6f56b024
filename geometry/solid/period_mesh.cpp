// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/period_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/period_frame.h"
#include "geometry/solid/refined_triangles.h"

namespace latticast {
namespace {

constexpr int most_rounds = 12;
constexpr int most_turns = 5;
constexpr double per_key = 1e5;  // places on a side, per mm, that are told apart

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Points of which those nearer than `PeriodFrame::same_place_mm` are one: the first.
class PlaceSet {
 public:
  std::uint32_t number(PlanePoint p) {
    const Key key = key_of(p);
    for (int i = 0; i < 9; ++i) {
      const auto found = numbers_.find({key.first + i % 3 - 1, key.second + i / 3 - 1});
      if (found == numbers_.end()) continue;
      if (distance(points_[found->second], p) < PeriodFrame::same_place_mm) return found->second;
    }
    numbers_.emplace(key, static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  const std::vector<PlanePoint>& points() const { return points_; }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  static Key key_of(PlanePoint p) {
    constexpr double cell = 2 * PeriodFrame::same_place_mm;
    return {std::llround(p.u / cell), std::llround(p.z / cell)};
  }

  std::map<Key, std::uint32_t> numbers_;
  std::vector<PlanePoint> points_;
};

/// A period's edges, and what each is: a piece of outline, or none of the frame.
struct PeriodEdges {
  PlaceSet places;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<const OutlinePiece*> pieces;

  void add(PlanePoint a, PlanePoint b, const OutlinePiece* piece) {
    const std::array<std::uint32_t, 2> edge = {places.number(a), places.number(b)};
    if (edge[0] == edge[1]) return;
    edges.push_back(edge);
    pieces.push_back(piece);
  }
};

/// The frame first, so that what the outline has on it takes the frame's places.
PeriodEdges edges_of(const PeriodFrame& frame, const PeriodOutline& outline) {
  PeriodEdges all;
  for (const PeriodSide side : period_sides) {
    const std::vector<PlanePoint> ends = frame.division(side);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) all.add(ends[i], ends[i + 1], nullptr);
  }
  for (std::size_t e = 0; e < outline.edges.size(); ++e) {
    const auto& [a, b] = outline.edges[e];
    all.add(outline.points[a], outline.points[b], &outline.pieces[e]);
  }
  return all;
}

/// Points that refinement put on the frame.
std::vector<PlanePoint> frame_points(const PeriodEdges& edges, const RefinedTriangles& refined) {
  std::vector<PlanePoint> points;
  for (std::size_t e = 0; e < refined.edges.size(); ++e) {
    if (edges.pieces[e] != nullptr) continue;
    for (const std::uint32_t v : refined.edges[e]) points.push_back(refined.points[v]);
  }
  return points;
}

/// Triangles with nodes, layers and images, from those that are refined far enough.
class MeshFinisher {
 public:
  MeshFinisher(const PeriodEdges& edges, const RefinedTriangles& refined, const PeriodFrame& frame,
               const Period& period, const PeriodBox& box)
      : edges_(edges), refined_(refined), frame_(frame), period_(period) {
    mesh_.box = box;
  }

  /// Nothing where sides along curves turn triangles over.
  std::optional<PeriodMesh> finish() {
    place_corners();
    for (const auto& [a, b, c] : refined_.triangles) {
      mesh_.triangles.push_back({{a, b, c, middle_of(a, b), middle_of(b, c), middle_of(c, a)}, 0});
    }
    bend_edges();
    if (!are_triangles_upright()) return std::nullopt;
    find_layers();
    find_images();
    return std::move(mesh_);
  }

 private:
  /// Calls visit(a, b, piece, t of a, t of b) for every edge along an outline.
  template <class Visit>
  void for_each_piece(Visit&& visit) const {
    for (std::size_t e = 0; e < refined_.edges.size(); ++e) {
      if (edges_.pieces[e] == nullptr) continue;
      const std::vector<std::uint32_t>& split = refined_.edges[e];
      const PlanePoint start = refined_.points[split.front()];
      const double length = distance(start, refined_.points[split.back()]);
      const auto t_of = [&](std::uint32_t v) {
        return distance(start, refined_.points[v]) / length;
      };
      for (std::size_t i = 0; i + 1 < split.size(); ++i) {
        visit(split[i], split[i + 1], e, t_of(split[i]), t_of(split[i + 1]));
      }
    }
  }

  PlanePoint on_curve(std::size_t e, double t) const {
    const std::vector<std::uint32_t>& split = refined_.edges[e];
    return edges_.pieces[e]->at(t, refined_.points[split.front()], refined_.points[split.back()]);
  }

  void place_corners() {
    for (std::uint32_t i = 0; i < refined_.points.size(); ++i) {
      mesh_.nodes.push_back({refined_.points[i], i});
    }
    for_each_piece([&](std::uint32_t a, std::uint32_t, std::size_t e, double t, double) {
      if (t > 0) mesh_.nodes[a].at = on_curve(e, t);
    });
  }

  std::uint32_t middle_of(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh_.nodes.size()));
    if (is_new) {
      mesh_.nodes.push_back({middle(mesh_.nodes[a].at, mesh_.nodes[b].at), found->second});
    }
    return found->second;
  }

  void bend_edges() {
    for_each_piece([&](std::uint32_t a, std::uint32_t b, std::size_t e, double t_a, double t_b) {
      const auto& curve = edges_.pieces[e]->curve;
      if (!curve || std::holds_alternative<StraightLine>(curve->shape)) return;
      mesh_.nodes[middle_of(a, b)].at = on_curve(e, 0.5 * (t_a + t_b));
    });
  }

  /// A positive map at its corners, where a quadratic triangle turns over first.
  bool are_triangles_upright() const {
    for (const PeriodMesh::Triangle& triangle : mesh_.triangles) {
      std::array<PlanePoint, 6> p;
      for (std::size_t i = 0; i < 6; ++i) p[i] = mesh_.nodes[triangle.nodes[i]].at;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        // Along both sides from a corner: 4 middle - 3 here - there.
        const auto away = [&](PlanePoint half, PlanePoint far) -> PlanePoint {
          return {4 * half.u - 3 * p[i].u - far.u, 4 * half.z - 3 * p[i].z - far.z};
        };
        if (cross({}, away(p[3 + i], p[j]), away(p[3 + k], p[k])) <= 0) return false;
      }
    }
    return true;
  }

  void find_layers() {
    std::map<Edge, std::uint32_t> owner;  // of directed edges
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& n = mesh_.triangles[t].nodes;
      for (std::size_t i = 0; i < 3; ++i) owner[{n[i], n[(i + 1) % 3]}] = t;
    }
    std::set<Edge> walls;
    std::vector<char> is_known(mesh_.triangles.size());
    std::vector<std::uint32_t> open;
    const auto learn = [&](Edge edge, Layers layers) {
      const auto found = owner.find(edge);
      if (found == owner.end() || is_known[found->second] != 0) return;
      is_known[found->second] = 1;
      mesh_.triangles[found->second].layers = layers;
      open.push_back(found->second);
    };
    for_each_piece([&](std::uint32_t a, std::uint32_t b, std::size_t e, double, double) {
      walls.insert(std::minmax(a, b));
      learn({a, b}, edges_.pieces[e]->left);
      learn({b, a}, edges_.pieces[e]->right);
    });
    while (!open.empty()) {
      const PeriodMesh::Triangle triangle = mesh_.triangles[open.back()];
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = triangle.nodes[i];
        const std::uint32_t b = triangle.nodes[(i + 1) % 3];
        if (!walls.contains(std::minmax(a, b))) learn({b, a}, triangle.layers);
      }
    }
    if (std::find(is_known.begin(), is_known.end(), 0) != is_known.end()) {
      throw GeometryError("a period of the lattice has no outline");
    }
  }

  using SidePlaces = std::map<std::int64_t, std::uint32_t>;

  static std::uint32_t find(const SidePlaces& places, double along_mm) {
    const std::int64_t key = std::llround(along_mm * per_key);
    for (const std::int64_t k : {key, key - 1, key + 1}) {
      const auto found = places.find(k);
      if (found != places.end()) return found->second;
    }
    throw GeometryError("opposite sides of a period of the lattice differ");
  }

  void find_images() {
    DisjointSets sets(mesh_.nodes.size());
    SidePlaces left;
    SidePlaces bottom;
    for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) {
      const PlanePoint p = mesh_.nodes[i].at;
      if (frame_.is_on(PeriodSide::left, p)) left[std::llround(p.z * per_key)] = i;
      if (frame_.is_on(PeriodSide::bottom, p)) bottom[std::llround(p.u * per_key)] = i;
    }
    for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) {
      const PlanePoint p = mesh_.nodes[i].at;
      if (frame_.is_on(PeriodSide::right, p)) sets.join(i, find(left, p.z));
      if (period_.mirrored || !frame_.is_on(PeriodSide::top, p)) continue;
      sets.join(i, find(bottom, frame_.at_bottom(p.u)));
    }
    for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) mesh_.nodes[i].image = sets.root(i);
  }

  const PeriodEdges& edges_;
  const RefinedTriangles& refined_;
  const PeriodFrame& frame_;
  const Period& period_;
  PeriodMesh mesh_;
  std::map<Edge, std::uint32_t> middles_;
};

std::optional<PeriodMesh> tried(const Region& region, const Period& period,
                                const PeriodDivision& division) {
  const PeriodBox box = box_of(region.grid, period);
  const PeriodOutline outline = period_outline(region, period, division);
  PeriodFrame frame(outline, box, period, division.size_mm);
  for (int round = 0; round < most_rounds; ++round) {
    const PeriodEdges edges = edges_of(frame, outline);
    const RefinedTriangles refined =
        refined_triangles(edges.places.points(), edges.edges, division.size_mm);
    // What one side was split at, its opposite is split at as well.
    if (frame.add(frame_points(edges, refined))) continue;
    return MeshFinisher(edges, refined, frame, period, box).finish();
  }
  throw GeometryError("opposite sides of a period of the lattice could not be divided alike");
}

}  // namespace

PeriodMesh triangulate_period(const Region& region, const Period& period,
                              const PeriodDivision& division) {
  PeriodDivision finer = division;
  for (int turn = 0; turn < most_turns; ++turn, finer.most_turn_rad *= 0.6) {
    if (auto mesh = tried(region, period, finer)) return std::move(*mesh);
  }
  throw GeometryError(
      "curves of the lattice lie too near to each other for a unit cell's elements");
}

}  // namespace latticast
