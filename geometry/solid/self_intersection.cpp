// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/mesh/weld.h"
#include "geometry/solid/oriented_box.h"

namespace latticast {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact(const Point& p) {
  return {p[0], p[1], p[2]};
}

// Bounds in x, y, z and in the angle around the z axis. The end faces of a thick tube are long
// radial slivers: each one's box in x and y meets those of most others, but not its angles.
struct Box {
  std::array<double, 4> low{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 4> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Point& p) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
    const double angle = std::atan2(p[1], p[0]);
    low[3] = std::min(low[3], angle);
    high[3] = std::max(high[3], angle);
    if (p[0] == 0 && p[1] == 0) take_all_angles();
  }

  // To be called when a triangle's corners are in. Corners within a half turn span a cone that the
  // triangle stays in; otherwise it passes the axis, or the angle's jump.
  void close_angles() {
    constexpr double rounding = 1e-12;
    low[3] -= rounding;
    high[3] += rounding;
    if (!(high[3] - low[3] < 3)) take_all_angles();
  }

  void take_all_angles() {
    low[3] = -HUGE_VAL;
    high[3] = HUGE_VAL;
  }
  void add(const Box& box) {
    for (int i = 0; i < 4; ++i) {
      low[i] = std::min(low[i], box.low[i]);
      high[i] = std::max(high[i], box.high[i]);
    }
  }
  bool meets(const Box& box) const {
    return low[0] <= box.high[0] && box.low[0] <= high[0] && low[1] <= box.high[1] &&
           box.low[1] <= high[1] && low[2] <= box.high[2] && box.low[2] <= high[2] &&
           low[3] <= box.high[3] && box.low[3] <= high[3];
  }
};

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
    const Kernel::Triangle_3 exact_s = triangle(s);
    const Kernel::Triangle_3 exact_t = triangle(t);
    if (shared == 0) return CGAL::do_intersect(exact_s, exact_t);
    return CGAL::do_intersect(Kernel::Segment_3(point(s[1]), point(s[2])), exact_t) ||
           CGAL::do_intersect(Kernel::Segment_3(point(t[1]), point(t[2])), exact_s);
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

  Kernel::Point_3 point(std::uint32_t vertex) const { return exact(mesh_.vertices[vertex]); }
  Kernel::Triangle_3 triangle(const Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  const TriangleMesh& mesh_;
  std::vector<Plane> planes_;
};

// A balanced tree of boxes over the triangles in the order of a space-filling curve.
class BoxTree {
 public:
  BoxTree(const TriangleMesh& mesh, const std::vector<char>& skip) {
    std::vector<Box> boxes(mesh.triangles.size());
    Box all;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (const std::uint32_t vertex : mesh.triangles[i]) boxes[i].add(mesh.vertices[vertex]);
      boxes[i].close_angles();
      all.add(boxes[i]);
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (!skip[i]) order.emplace_back(place_on_curve(boxes[i], all), i);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [place, triangle] : order) {
      triangles_.push_back(triangle);
      boxes_.push_back(boxes[triangle]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double largest = std::max(std::abs(all.low[axis]), std::abs(all.high[axis]));
      margin_ = std::max(margin_, 1e-12 * largest);
    }
    if (!triangles_.empty()) build(mesh, 0, 0, triangles_.size());
  }

  // Calls test(i, j) for every pair of triangles whose boxes meet.
  template <class Test>
  void for_each_close_pair(Test&& test) const {
    if (!triangles_.empty()) within(0, 0, triangles_.size(), test);
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  // Bounds are quick to compare. Those of long thin triangles that lie askew side by side meet each
  // other, however thin; the oriented boxes do not.
  struct Node {
    Box bounds;
    OrientedBox oriented;

    void add(const Node& node) {
      bounds.add(node.bounds);
      oriented = OrientedBox::around(oriented, node.oriented);
    }
    bool may_meet(const Node& node) const {
      return bounds.meets(node.bounds) && oriented.may_meet(node.oriented);
    }
  };

  // Position of the box's middle on a Morton curve with 21 bits an axis.
  static std::uint64_t place_on_curve(const Box& box, const Box& all) {
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

  static std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 32) & 0x1F00000000FFFFULL;
    x = (x | x << 16) & 0x1F0000FF0000FFULL;
    x = (x | x << 8) & 0x100F00F00F00F00FULL;
    x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
    return (x | x << 2) & 0x1249249249249249ULL;
  }

  static std::size_t half(std::size_t from, std::size_t to) { return from + (to - from) / 2; }

  // Node n's children are 2n + 1 and 2n + 2, each with half of its triangles.
  void build(const TriangleMesh& mesh, std::size_t node, std::size_t from, std::size_t to) {
    if (nodes_.size() <= node) nodes_.resize(2 * node + 1);
    if (to - from <= leaf_size) {
      nodes_[node] = leaf(mesh, from);
      for (std::size_t i = from + 1; i < to; ++i) nodes_[node].add(leaf(mesh, i));
    } else {
      build(mesh, 2 * node + 1, from, half(from, to));
      build(mesh, 2 * node + 2, half(from, to), to);
      nodes_[node] = nodes_[2 * node + 1];
      nodes_[node].add(nodes_[2 * node + 2]);
    }
  }

  Node leaf(const TriangleMesh& mesh, std::size_t i) const {
    const Triangle& t = mesh.triangles[triangles_[i]];
    return {boxes_[i], OrientedBox::around(mesh.vertices[t[0]], mesh.vertices[t[1]],
                                           mesh.vertices[t[2]], margin_)};
  }

  template <class Test>
  void within(std::size_t node, std::size_t from, std::size_t to, Test& test) const {
    if (to - from <= leaf_size) {
      for (std::size_t i = from; i < to; ++i) {
        for (std::size_t j = i + 1; j < to; ++j) test_pair(i, j, test);
      }
      return;
    }
    const std::size_t middle = half(from, to);
    within(2 * node + 1, from, middle, test);
    within(2 * node + 2, middle, to, test);
    between(2 * node + 1, from, middle, 2 * node + 2, middle, to, test);
  }

  template <class Test>
  void between(std::size_t a, std::size_t a_from, std::size_t a_to, std::size_t b,
               std::size_t b_from, std::size_t b_to, Test& test) const {
    if (!nodes_[a].may_meet(nodes_[b])) return;
    const bool a_is_leaf = a_to - a_from <= leaf_size;
    const bool b_is_leaf = b_to - b_from <= leaf_size;
    if (a_is_leaf && b_is_leaf) {
      for (std::size_t i = a_from; i < a_to; ++i) {
        if (!boxes_[i].meets(nodes_[b].bounds)) continue;
        for (std::size_t j = b_from; j < b_to; ++j) test_pair(i, j, test);
      }
    } else if (b_is_leaf || (!a_is_leaf && a_to - a_from >= b_to - b_from)) {
      const std::size_t middle = half(a_from, a_to);
      between(2 * a + 1, a_from, middle, b, b_from, b_to, test);
      between(2 * a + 2, middle, a_to, b, b_from, b_to, test);
    } else {
      const std::size_t middle = half(b_from, b_to);
      between(a, a_from, a_to, 2 * b + 1, b_from, middle, test);
      between(a, a_from, a_to, 2 * b + 2, middle, b_to, test);
    }
  }

  template <class Test>
  void test_pair(std::size_t i, std::size_t j, Test& test) const {
    if (boxes_[i].meets(boxes_[j])) test(triangles_[i], triangles_[j]);
  }

  double margin_ = 0;
  std::vector<std::uint32_t> triangles_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(
    const TriangleMesh& mesh, const std::vector<char>& skip) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  const PairTest meet(mesh);
  BoxTree(mesh, skip).for_each_close_pair([&](std::uint32_t i, std::uint32_t j) {
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
