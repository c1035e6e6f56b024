// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/self_intersection.h"

#include <set>
#include <string>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "tests/unit/geometry/solid/example_bodies.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Do two triangles have points in common beside the vertices and the edge that they share? Decided
// on the exact intersection itself, which the code under test never builds.
bool meet_elsewhere(const TriangleMesh& mesh, const Triangle& s, const Triangle& t) {
  const auto point = [&](std::uint32_t v) {
    const Point& p = mesh.vertices[v];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  std::vector<std::uint32_t> shared;
  for (const std::uint32_t v : s) {
    if (std::find(t.begin(), t.end(), v) != t.end()) shared.push_back(v);
  }
  const Kernel::Triangle_3 first(point(s[0]), point(s[1]), point(s[2]));
  const Kernel::Triangle_3 second(point(t[0]), point(t[1]), point(t[2]));
  const auto common = CGAL::intersection(first, second);
  if (!common) return false;
  if (shared.empty()) return true;
  if (const auto* only = boost::get<Kernel::Point_3>(&*common)) {
    return shared.size() != 1 || *only != point(shared[0]);
  }
  if (const auto* along = boost::get<Kernel::Segment_3>(&*common)) {
    if (shared.size() != 2) return true;
    const Kernel::Segment_3 edge(point(shared[0]), point(shared[1]));
    return *along != edge && along->opposite() != edge;
  }
  return true;  // an area in common
}

Pairs every_pair(const TriangleMesh& mesh) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < mesh.triangles.size(); ++j) {
      if (meet_elsewhere(mesh, mesh.triangles[i], mesh.triangles[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Pairs found(const TriangleMesh& mesh) {
  return self_intersections(mesh, std::vector<char>(mesh.triangles.size(), 0));
}

// Coordinates on a small grid make touching, coplanar and collinear cases common.
TriangleMesh random_soup(RandomNumbers& random, bool on_grid) {
  TriangleMesh mesh;
  const double size = random.log_between(0.1, 1);
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Point at{random.between(0, 3), random.between(0, 3), random.between(0, 3)};
    for (int corner = 0; corner < 3; ++corner) {
      Point p;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = on_grid ? random.whole(0, 5) : at[axis] + size * random.between(-1, 1);
      }
      mesh.vertices.push_back(p);
    }
    const Triangle triangle{3 * i, 3 * i + 1, 3 * i + 2};
    if (!is_degenerate(mesh, triangle)) mesh.triangles.push_back(triangle);
  }
  return mesh;
}

TEST(SelfIntersections, OfRandomSoupsAreThoseOfEveryPair) {
  constexpr std::uint64_t seed = 4001;
  std::size_t pairs = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const TriangleMesh mesh = random_soup(random, i % 2 == 0);
    const Pairs expected = every_pair(mesh);
    ASSERT_EQ(found(mesh), expected);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 5000U);
}

TEST(SelfIntersections, OfPerturbedBodiesAreThoseOfEveryPair) {
  constexpr std::uint64_t seed = 4301;
  std::size_t clean = 0;
  std::size_t pairs = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    TriangleMesh mesh = torus(9, 5);
    const double shake = random.log_between(0.01, 2);
    for (Point& p : mesh.vertices) {
      for (double& x : p) x += shake * random.between(-1, 1);
      // A third of them on a coarse grid, for coplanar neighbours and folds.
      if (i % 3 == 0) {
        for (double& x : p) x = std::round(x);
      }
    }
    std::erase_if(mesh.triangles, [&](const Triangle& t) { return is_degenerate(mesh, t); });
    const Pairs expected = every_pair(mesh);
    ASSERT_EQ(found(mesh), expected);
    clean += expected.empty();
    pairs += expected.size();
  }
  EXPECT_GT(clean, 5U);
  EXPECT_GT(pairs, 500U);
}

TEST(SelfIntersections, OfRandomlyJoinedTrianglesAreThoseOfEveryPair) {
  // Few vertices, so that triangles share one, two and all three of them in any order.
  constexpr std::uint64_t seed = 4501;
  for (std::uint64_t i = 0; i < 150; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    TriangleMesh mesh;
    std::set<std::array<int, 3>> places;
    while (places.size() < 12) {
      places.insert({random.whole(0, 4), random.whole(0, 4), i % 3 == 0 ? 0 : random.whole(0, 4)});
    }
    for (const auto& [x, y, z] : places) {
      mesh.vertices.push_back({double(x), double(y), double(z)});
    }
    while (mesh.triangles.size() < 25) {
      const auto corner = [&] { return static_cast<std::uint32_t>(random.whole(0, 11)); };
      const Triangle triangle{corner(), corner(), corner()};
      if (!is_degenerate(mesh, triangle)) mesh.triangles.push_back(triangle);
    }
    ASSERT_EQ(found(mesh), every_pair(mesh));
  }
}

// Strands around a tube leave slivers that lie askew side by side; some of these are shifted.
TriangleMesh askew_slivers(RandomNumbers& random, bool in_a_plane) {
  TriangleMesh mesh;
  const double width = random.log_between(1e-3, 0.1);
  const Point along{random.between(-1, 1), random.between(-1, 1), 1};
  for (std::uint32_t i = 0; i < 60; ++i) {
    const double lift = 0.2 * width * random.between(-1, 1);
    for (const auto& [part, side] : {std::pair(0.0, 0.0), {1.0, 0.3}, {0.4, 0.9}}) {
      Point p{width * (i + side + 0.3 * random.between(-1, 1)), lift, 0};
      for (int axis = 0; axis < 3; ++axis) p[axis] += part * along[axis];
      if (in_a_plane) p[1] = 2 * p[0];
      mesh.vertices.push_back(p);
    }
    const Triangle triangle{3 * i, 3 * i + 1, 3 * i + 2};
    if (!is_degenerate(mesh, triangle)) mesh.triangles.push_back(triangle);
  }
  return mesh;
}

TEST(SelfIntersections, OfSliversSideBySideAreThoseOfEveryPair) {
  constexpr std::uint64_t seed = 4701;
  std::size_t pairs = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const TriangleMesh mesh = askew_slivers(random, i % 2 == 0);
    const Pairs expected = every_pair(mesh);
    ASSERT_EQ(found(mesh), expected);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 50U);
}

TEST(SelfIntersections, LeaveOutWhatIsSkipped) {
  TriangleMesh mesh = together(tetrahedron(), placed(tetrahedron(), 1, {0.2, 0.2, 0.2}));
  ASSERT_FALSE(found(mesh).empty());
  std::vector<char> skip(mesh.triangles.size(), 0);
  for (const auto& [first, second] : found(mesh)) skip[second] = 1;
  EXPECT_TRUE(self_intersections(mesh, skip).empty());
  EXPECT_TRUE(self_intersections(mesh, std::vector<char>(mesh.triangles.size(), 1)).empty());
  EXPECT_TRUE(self_intersections({}, {}).empty());
}

TEST(IsDegenerate, IsExact) {
  const auto flat = [](const Point& a, const Point& b, const Point& c) {
    return is_degenerate({{a, b, c}, {}}, {0, 1, 2});
  };
  EXPECT_TRUE(flat({0, 0, 0}, {1, 1, 1}, {3, 3, 3}));
  EXPECT_TRUE(flat({1, 2, 3}, {1, 2, 3}, {4, 5, 6}));
  EXPECT_FALSE(flat({0, 0, 0}, {1, 1, 1}, {3, 3, 3 + 0x1p-50}));
  EXPECT_FALSE(flat({1e6, 0, 0}, {2e6, 0, 0x1p-140}, {3e6, 0, 0}));
  EXPECT_TRUE(is_degenerate(tetrahedron(), {2, 0, 2}));
}

}  // namespace
}  // namespace latticast
