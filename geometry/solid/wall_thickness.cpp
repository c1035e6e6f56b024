// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "design/units.h"
#include "geometry/mesh/point_algebra.h"
#include "geometry/solid/box_tree.h"

namespace latticast {
namespace {

constexpr double most_points = 400'000;

struct Facet {
  std::array<Point, 3> corners;
  Point normal{};  // of unit length
  double area = 0;
  bool sure = true;  // of its normal; false for slivers that rounding may have turned
};

// By how much float32, relative to the largest coordinate, may lift a corner off its plane.
constexpr double rounding = 0x1p-23;

double longest_side(const Facet& facet) {
  const auto& [a, b, c] = facet.corners;
  const Point sides[] = {difference(b, a), difference(c, b), difference(a, c)};
  double longest = 0;
  for (const Point& side : sides) longest = std::max(longest, dot(side, side));
  return std::sqrt(longest);
}

double largest_coordinate(const TriangleMesh& mesh) {
  double largest = 0;
  for (const Point& p : mesh.vertices) {
    for (const double x : p) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

std::vector<Facet> facets_of(const TriangleMesh& mesh) {
  const double least_height =
      rounding * largest_coordinate(mesh) / std::tan(radians(sharpest_wedge_deg));
  std::vector<Facet> facets;
  facets.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Facet facet{{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}};
    const auto& [a, b, c] = facet.corners;
    const Point square = cross(difference(b, a), difference(c, a));
    const double twice = std::sqrt(dot(square, square));
    if (twice == 0) continue;  // too thin for floating point: no surface to speak of
    facet.normal = {square[0] / twice, square[1] / twice, square[2] / twice};
    facet.area = 0.5 * twice;
    facet.sure = twice > least_height * longest_side(facet);
    facets.push_back(facet);
  }
  return facets;
}

/// Facets in the order of their tree: near ones together.
class FacetTree {
 public:
  explicit FacetTree(const std::vector<Facet>& facets) {
    std::vector<Place> places(facets.size());
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      places[i].facet = i;
      const auto& [a, b, c] = facets[i].corners;
      for (int k = 0; k < 3; ++k) places[i].middle[k] = static_cast<float>(a[k] + b[k] + c[k]);
    }
    sort(places, {0, places.size()});
    facets_.reserve(facets.size());
    for (const Place& place : places) facets_.push_back(facets[place.facet]);
    tree_ = {facets_.size(), [this](std::size_t i) {
               Box<3> box;
               for (const Point& corner : facets_[i].corners) box.add(corner);
               return box;
             }};
  }

  const std::vector<Facet>& facets() const { return facets_; }

  template <class Visit>
  void for_each_near(const Box<3>& box, const Visit& visit) const {
    tree_.for_each_meeting(box, [&](const LeafItems& leaf) {
      for (std::size_t i = leaf.from; i < leaf.to; ++i) visit(facets_[i]);
    });
  }

 private:
  struct Place {
    std::array<float, 3> middle;  // three times, which orders as well
    std::uint32_t facet;
  };

  // Along which the middles of the facets are spread most.
  static std::size_t widest_axis(const std::vector<Place>& places, const LeafItems& items) {
    std::array<float, 3> low = places[items.from].middle;
    std::array<float, 3> high = low;
    for (std::size_t i = items.from + 1; i < items.to; ++i) {
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], places[i].middle[k]);
        high[k] = std::max(high[k], places[i].middle[k]);
      }
    }
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (high[k] - low[k] > high[widest] - low[widest]) widest = k;
    }
    return widest;
  }

  static void sort(std::vector<Place>& places, const LeafItems& items) {
    if (BoxTree<Box<3>>::is_leaf(items)) return;
    const std::size_t axis = widest_axis(places, items);
    const std::size_t split = BoxTree<Box<3>>::middle(items);
    const auto at = [&](std::size_t i) { return places.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(
        at(items.from), at(split), at(items.to),
        [axis](const Place& a, const Place& b) { return a.middle[axis] < b.middle[axis]; });
    sort(places, {items.from, split});
    sort(places, {split, items.to});
  }

  std::vector<Facet> facets_;
  BoxTree<Box<3>> tree_;
};

/// How far along `direction` the line from a point meets the facet. The facet is taken a hair
/// larger: a line through an edge must not slip between its two facets.
std::optional<double> distance_along(const Point& from, const Point& direction,
                                     const Facet& facet) {
  constexpr double hair = 1e-9;
  const auto& [a, b, c] = facet.corners;
  const Point u = difference(b, a);
  const Point v = difference(c, a);
  const Point across = cross(direction, v);
  const double volume = dot(u, across);
  if (volume == 0) return std::nullopt;
  const Point offset = difference(from, a);
  const double s = dot(offset, across) / volume;
  const Point square = cross(offset, u);
  const double t = dot(direction, square) / volume;
  if (s < -hair || t < -hair || s + t > 1 + hair) return std::nullopt;
  return dot(v, square) / volume;
}

/// From a point to the nearest point of a facet.
double distance_from(const Point& point, const Facet& facet) {
  const double height = dot(difference(point, facet.corners[0]), facet.normal);
  double beside = HUGE_VAL;
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    const Point side = difference(facet.corners[(i + 1) % 3], facet.corners[i]);
    const Point offset = difference(point, facet.corners[i]);
    inside = inside && dot(cross(side, offset), facet.normal) >= 0;
    const double along = std::clamp(dot(offset, side) / dot(side, side), 0.0, 1.0);
    const Point gap = moved(offset, side, -along);
    beside = std::min(beside, std::sqrt(dot(gap, gap)));
  }
  return inside ? std::abs(height) : beside;
}

/// Calls visit(point, area) for points spread over the facet, with the area that each stands for:
/// one in the middle of small facets, otherwise rows of them along the longest side.
template <class Visit>
void spread_points(const Facet& facet, double spacing, Visit&& visit) {
  const double square = spacing * spacing;
  if (facet.area <= square) {
    const auto& [a, b, c] = facet.corners;
    Point middle;
    for (int i = 0; i < 3; ++i) middle[i] = (a[i] + b[i] + c[i]) / 3;
    visit(middle, facet.area);
    return;
  }
  double longest = 0;
  int first = 0;
  for (int i = 0; i < 3; ++i) {
    const Point side = difference(facet.corners[(i + 1) % 3], facet.corners[i]);
    if (dot(side, side) > longest) {
      longest = dot(side, side);
      first = i;
    }
  }
  const Point& a = facet.corners[first];
  const Point base = difference(facet.corners[(first + 1) % 3], a);
  const Point slant = difference(facet.corners[(first + 2) % 3], a);
  const int rows = static_cast<int>(std::ceil(2 * facet.area / std::sqrt(longest) / spacing));
  for (int row = 0; row < rows; ++row) {
    const double up = (row + 0.5) / rows;
    const double area = facet.area * (2 * (rows - row) - 1) / (double(rows) * rows);
    const int count = static_cast<int>(std::ceil(area / square));
    for (int i = 0; i < count; ++i) {
      visit(moved(moved(a, slant, up), base, (1 - up) * (i + 0.5) / count), area / count);
    }
  }
}

/// What lies under a point of the surface.
struct Opposite {
  double distance = 0;
  const Facet* facet = nullptr;
};

/// The nearest surface along the inward normal, within the limit.
std::optional<Opposite> opposite(const Point& point, const Facet& facet, const FacetTree& tree,
                                 double limit) {
  const Point inward = {-facet.normal[0], -facet.normal[1], -facet.normal[2]};
  Box<3> way;
  way.add(point);
  way.add(moved(point, inward, limit));
  Opposite nearest{limit, nullptr};
  tree.for_each_near(way, [&](const Facet& other) {
    // The way out of a body is through a face that looks along it.
    if (dot(facet.normal, other.normal) >= 0) return;
    const auto distance = distance_along(point, inward, other);
    if (distance && *distance >= 0 && *distance < nearest.distance) nearest = {*distance, &other};
  });
  return nearest.facet ? std::optional(nearest) : std::nullopt;
}

/// Whether the two sides run into each other: the opposite one is there, or nearly so, where the
/// planes of both meet.
bool meets_in_an_edge(const Point& point, const Facet& facet, const Opposite& under,
                      const FacetTree& tree) {
  const double facing = dot(facet.normal, under.facet->normal);
  const double sine = std::sqrt(1 - facing * facing);
  Point toward_edge = moved(under.facet->normal, facet.normal, -facing);
  for (double& component : toward_edge) component /= sine;
  const Point edge = moved(point, toward_edge, -under.distance * facing / sine);
  const double near = 0.5 * under.distance;
  Box<3> around;
  around.add({edge[0] - near, edge[1] - near, edge[2] - near});
  around.add({edge[0] + near, edge[1] + near, edge[2] + near});
  bool meets = false;
  tree.for_each_near(around, [&](const Facet& other) {
    if (dot(other.normal, under.facet->normal) < std::cos(radians(sharpest_wedge_deg))) return;
    meets = meets || distance_from(edge, other) <= near;
  });
  return meets;
}

/// The thickness of the body under a point of a facet, where it is below the limit and a wall's.
std::optional<double> wall_under(const Point& point, const Facet& facet, const FacetTree& tree,
                                 double limit) {
  const auto under = opposite(point, facet, tree, limit);
  if (!under || !under->facet->sure) return std::nullopt;
  const double facing = -dot(facet.normal, under->facet->normal);
  if (facing < std::cos(radians(widest_taper_deg))) return std::nullopt;
  if (facing < std::cos(radians(sharpest_wedge_deg)) &&
      meets_in_an_edge(point, facet, *under, tree)) {
    return std::nullopt;
  }
  return under->distance;
}

}  // namespace

ThinWalls thin_walls(const TriangleMesh& sound, double limit_mm) {
  const FacetTree tree(facets_of(sound));
  ThinWalls found;
  for (const Facet& facet : tree.facets()) found.surface_mm2 += facet.area;
  const double spacing = std::max(limit_mm, std::sqrt(found.surface_mm2 / most_points));
  for (const Facet& facet : tree.facets()) {
    if (!facet.sure) continue;
    spread_points(facet, spacing, [&](const Point& point, double area) {
      const auto thickness = wall_under(point, facet, tree, limit_mm);
      if (!thickness) return;
      found.thinner_mm2 += area;
      if (*thickness >= found.least_mm) return;
      found.least_mm = *thickness;
      found.where = moved(point, facet.normal, -0.5 * *thickness);
    });
  }
  return found;
}

}  // namespace latticast
