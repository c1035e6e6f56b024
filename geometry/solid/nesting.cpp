// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/nesting.h"

#include <algorithm>
#include <cmath>

#include "geometry/solid/box_tree.h"
#include "geometry/solid/exact_kernel.h"

namespace latticast {
namespace {

bool surrounds(const Box<3>& outer, const Box<3>& inner) {
  for (int i = 0; i < 3; ++i) {
    if (outer.low[i] >= inner.low[i] || outer.high[i] <= inner.high[i]) return false;
  }
  return true;
}

Box<3> box_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& body) {
  Box<3> box;
  for (const std::uint32_t t : body) {
    for (const std::uint32_t v : mesh.triangles[t]) box.add(mesh.vertices[v]);
  }
  return box;
}

ExactKernel::Point_2 seen_along_x(const Point& p) {
  return {p[1], p[2]};
}

// +1 or -1 where the side from a to b, seen along x, passes p on the right, going up or down. A
// point level with a corner counts as above it, and one in line with the side as to its right;
// both triangles at a side judge alike, so that a ray through it meets exactly one of them.
int passes(const Point& a, const Point& b, const Point& p) {
  const bool a_below = a[2] <= p[2];
  const bool b_below = b[2] <= p[2];
  if (a_below == b_below) return 0;
  const Point& low = a_below ? a : b;
  const Point& high = a_below ? b : a;
  if (CGAL::orientation(seen_along_x(low), seen_along_x(high), seen_along_x(p)) !=
      CGAL::LEFT_TURN) {
    return 0;
  }
  return a_below ? 1 : -1;
}

// +1 where a ray from p along x leaves the solid through the triangle, -1 where it enters.
int crossing(const TriangleMesh& mesh, const Triangle& t, const Point& p) {
  const Point& a = mesh.vertices[t[0]];
  const Point& b = mesh.vertices[t[1]];
  const Point& c = mesh.vertices[t[2]];
  if (std::max({a[0], b[0], c[0]}) < p[0]) return 0;
  const int facing = passes(a, b, p) + passes(b, c, p) + passes(c, a, p);
  if (facing == 0) return 0;
  const int side = CGAL::orientation(exact(a), exact(b), exact(c), exact(p));
  return side == -facing ? facing : 0;
}

int winding(const TriangleMesh& mesh, const std::vector<std::uint32_t>& body, const Point& p) {
  int sum = 0;
  for (const std::uint32_t t : body) sum += crossing(mesh, mesh.triangles[t], p);
  return sum;
}

}  // namespace

std::vector<int> surrounding_winding(const TriangleMesh& mesh,
                                     const std::vector<std::vector<std::uint32_t>>& bodies) {
  std::vector<Box<3>> boxes;
  boxes.reserve(bodies.size());
  for (const auto& body : bodies) boxes.push_back(box_of(mesh, body));
  std::vector<int> windings(bodies.size(), 0);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Point& p = mesh.vertices[mesh.triangles[bodies[i].front()][0]];
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (surrounds(boxes[j], boxes[i])) windings[i] += winding(mesh, bodies[j], p);
    }
  }
  return windings;
}

}  // namespace latticast
