// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/mesh/weld.h"
#include "geometry/solid/box_tree.h"
#include "geometry/solid/exact_kernel.h"
#include "geometry/solid/oriented_box.h"

namespace latticast {
namespace {

// Bounds in x, y, z and in the angle around the z axis. The end faces of a thick tube are long
// radial slivers: each one's box in x and y meets those of most others, but not its angles.
Box<4> bounds_of(const TriangleMesh& mesh, const Triangle& t) {
  constexpr double rounding = 1e-12;
  Box<4> bounds;
  bool on_axis = false;
  for (const std::uint32_t vertex : t) {
    const Point& p = mesh.vertices[vertex];
    bounds.add({p[0], p[1], p[2], std::atan2(p[1], p[0])});
    on_axis = on_axis || (p[0] == 0 && p[1] == 0);
  }
  bounds.low[3] -= rounding;
  bounds.high[3] += rounding;
  // Corners within a half turn span a cone that the triangle stays in; otherwise it passes the
  // axis, or the angle's jump.
  if (on_axis || !(bounds.high[3] - bounds.low[3] < 3)) {
    bounds.low[3] = -HUGE_VAL;
    bounds.high[3] = HUGE_VAL;
  }
  return bounds;
}

// Tells exactly whether two triangles meet where they should not. A plane test in plain floating
// point with an error bound settles nearly all pairs; the rest goes to exact predicates.
class PairTest {
 public:
  explicit PairTest(const TriangleMesh& mesh) : mesh_(mesh), planes_(mesh.triangles.size()) {
    for (std::size_t i = 0; i < planes_.size(); ++i) planes_[i] = plane_of(mesh.triangles[i]);
  }

  bool operator()(std::uint32_t first, std::uint32_t second) const {
    Triangle s = mesh_.triangles[first];
    Triangle t = mesh_.triangles[second];
    const int shared = gather_shared(s, t);
    if (shared == 3) return true;
    if (shared == 2) return folds(first, s, t);
    if (one_side(first, t, shared) || one_side(second, s, shared)) return false;
    const ExactKernel::Triangle_3 exact_s = triangle(s);
    const ExactKernel::Triangle_3 exact_t = triangle(t);
    if (shared == 0) return CGAL::do_intersect(exact_s, exact_t);
    return CGAL::do_intersect(ExactKernel::Segment_3(point(s[1]), point(s[2])), exact_t) ||
           CGAL::do_intersect(ExactKernel::Segment_3(point(t[1]), point(t[2])), exact_s);
  }

 private:
  struct Plane {
    Point through;
    Point normal;
    Point products;  // sums of the magnitudes that the normal's components are differences of
  };

  Plane plane_of(const Triangle& t) const {
    const Point& a = mesh_.vertices[t[0]];
    Plane plane{a, {}, {}};
    Point u;
    Point v;
    for (int i = 0; i < 3; ++i) {
      u[i] = mesh_.vertices[t[1]][i] - a[i];
      v[i] = mesh_.vertices[t[2]][i] - a[i];
    }
    for (int i = 0; i < 3; ++i) {
      const double plus = u[(i + 1) % 3] * v[(i + 2) % 3];
      const double minus = u[(i + 2) % 3] * v[(i + 1) % 3];
      plane.normal[i] = plus - minus;
      plane.products[i] = std::abs(plus) + std::abs(minus);
    }
    return plane;
  }

  // The side of triangle i's plane on which a vertex lies: -1, 0 or 1.
  int side(std::uint32_t i, std::uint32_t vertex) const {
    const Plane& plane = planes_[i];
    const Point& p = mesh_.vertices[vertex];
    double height = 0;
    double magnitude = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double offset = p[axis] - plane.through[axis];
      height += plane.normal[axis] * offset;
      magnitude += plane.products[axis] * std::abs(offset);
    }
    // Each term carries at most 5 roundings, their sum 2 more; 16 epsilon covers them with room.
    // The bound is 0 only where every product is, as for a point in the plane of an axis-parallel
    // triangle.
    const double bound = 16 * 0x1p-52 * magnitude;
    if (height > bound) return 1;
    if (height < -bound) return -1;
    if (bound == 0) return 0;
    const Triangle& t = mesh_.triangles[i];
    return static_cast<int>(
        CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(vertex)));
  }

  // Moves shared vertices to the front of both triangles, in the same order.
  static int gather_shared(Triangle& s, Triangle& t) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = shared; j < 3; ++j) {
        if (s[i] != t[j]) continue;
        std::swap(t[j], t[shared]);
        std::swap(s[i], s[shared]);
        ++shared;
        break;
      }
    }
    return shared;
  }

  bool one_side(std::uint32_t plane, const Triangle& t, int first) const {
    const int expected = side(plane, t[first]);
    if (expected == 0) return false;
    for (int i = first + 1; i < 3; ++i) {
      if (side(plane, t[i]) != expected) return false;
    }
    return true;
  }

  // Two triangles with a common edge meet elsewhere only if they lie in one plane, on the same side
  // of it.
  bool folds(std::uint32_t first, const Triangle& s, const Triangle& t) const {
    if (side(first, t[2]) != 0) return false;
    return CGAL::coplanar_orientation(point(s[0]), point(s[1]), point(s[2]), point(t[2])) ==
           CGAL::POSITIVE;
  }

  ExactKernel::Point_3 point(std::uint32_t vertex) const { return exact(mesh_.vertices[vertex]); }
  ExactKernel::Triangle_3 triangle(const Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  const TriangleMesh& mesh_;
  std::vector<Plane> planes_;
};

// Boxes are quick to compare. Those of long thin triangles that lie askew side by side meet each
// other, however thin; the oriented boxes do not.
struct Bounds {
  Box<4> box;
  OrientedBox oriented;

  void add(const Bounds& other) {
    box.add(other.box);
    oriented = OrientedBox::around(oriented, other.oriented);
  }
  bool meets(const Bounds& other) const {
    return box.meets(other.box) && oriented.may_meet(other.oriented);
  }
};

std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x1F00000000FFFFULL;
  x = (x | x << 16) & 0x1F0000FF0000FFULL;
  x = (x | x << 8) & 0x100F00F00F00F00FULL;
  x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

// Position of the box's middle on a Morton curve with 21 bits an axis.
std::uint64_t place_on_curve(const Box<4>& box, const Box<4>& all) {
  std::uint64_t place = 0;
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, all.high[axis] - all.low[axis]);
  if (extent == 0) return 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = 0.5 * (box.low[axis] + box.high[axis]) - all.low[axis];
    place |= spread_bits(static_cast<std::uint64_t>(middle / extent * 0x1FFFFF)) << axis;
  }
  return place;
}

// The triangles that are not skipped, in the order of a space-filling curve, under a tree.
class TriangleTree {
 public:
  TriangleTree(const TriangleMesh& mesh, const std::vector<char>& skip) {
    std::vector<Box<4>> boxes(mesh.triangles.size());
    Box<4> all;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      boxes[i] = bounds_of(mesh, mesh.triangles[i]);
      all.add(boxes[i]);
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (!skip[i]) order.emplace_back(place_on_curve(boxes[i], all), i);
    }
    std::sort(order.begin(), order.end());
    triangles_.reserve(order.size());
    boxes_.reserve(order.size());
    for (const auto& [place, triangle] : order) {
      triangles_.push_back(triangle);
      boxes_.push_back(boxes[triangle]);
    }
    double margin = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double largest = std::max(std::abs(all.low[axis]), std::abs(all.high[axis]));
      margin = std::max(margin, 1e-12 * largest);
    }
    tree_ = {triangles_.size(), [&](std::size_t i) {
               const Triangle& t = mesh.triangles[triangles_[i]];
               return Bounds{boxes_[i],
                             OrientedBox::around(mesh.vertices[t[0]], mesh.vertices[t[1]],
                                                 mesh.vertices[t[2]], margin)};
             }};
  }

  // Calls test(i, j) for every pair of triangles whose boxes meet.
  template <class Test>
  void for_each_close_pair(const Test& test) const {
    const auto test_pair = [&](std::size_t i, std::size_t j) {
      if (boxes_[i].meets(boxes_[j])) test(triangles_[i], triangles_[j]);
    };
    const auto inside = [&](const LeafItems& leaf) {
      for (std::size_t i = leaf.from; i < leaf.to; ++i) {
        for (std::size_t j = i + 1; j < leaf.to; ++j) test_pair(i, j);
      }
    };
    const auto between = [&](const LeafItems& a, const LeafItems& b, const Bounds& of_b) {
      for (std::size_t i = a.from; i < a.to; ++i) {
        if (!boxes_[i].meets(of_b.box)) continue;
        for (std::size_t j = b.from; j < b.to; ++j) test_pair(i, j);
      }
    };
    tree_.for_each_close_pair(inside, between);
  }

 private:
  std::vector<std::uint32_t> triangles_;
  std::vector<Box<4>> boxes_;
  BoxTree<Bounds> tree_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(
    const TriangleMesh& mesh, const std::vector<char>& skip) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  const PairTest meet(mesh);
  TriangleTree(mesh, skip).for_each_close_pair([&](std::uint32_t i, std::uint32_t j) {
    if (meet(i, j)) found.emplace_back(std::min(i, j), std::max(i, j));
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool intersects_itself(const TriangleMesh& mesh) {
  const TriangleMesh welded = weld(mesh);
  std::vector<char> degenerate;
  degenerate.reserve(welded.triangles.size());
  for (const Triangle& t : welded.triangles) degenerate.push_back(is_degenerate(welded, t) ? 1 : 0);
  return !self_intersections(welded, degenerate).empty();
}

bool is_degenerate(const TriangleMesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  return CGAL::collinear(exact(mesh.vertices[t[0]]), exact(mesh.vertices[t[1]]),
                         exact(mesh.vertices[t[2]]));
}

}  // namespace latticast
