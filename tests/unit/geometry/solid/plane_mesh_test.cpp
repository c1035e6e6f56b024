// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_mesh.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/random_patterns.h"
#include "tests/unit/geometry/solid/square_patterns.h"

namespace latticast {
namespace {

// The sector of a triangle: that of a vertex inside it, or the one between the two lines that its
// corners lie on.
int sector_of(const PlaneMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  std::set<int> lines;
  for (const std::uint32_t v : triangle) {
    if (mesh.vertices[v].point.u > 0) return mesh.vertices[v].sector;
    lines.insert(mesh.vertices[v].sector);
  }
  if (*lines.rbegin() == mesh.grid.sectors - 1 && *lines.begin() == 0) return *lines.rbegin();
  return *lines.begin();
}

// Corners as seen from the triangle's sector. Fails for a triangle that reaches into another one.
std::array<GridPoint, 3> corners(const PlaneMesh& mesh,
                                 const std::array<std::uint32_t, 3>& triangle) {
  const int sector = sector_of(mesh, triangle);
  std::array<GridPoint, 3> points;
  for (int i = 0; i < 3; ++i) {
    const PlaneMeshVertex& v = mesh.vertices[triangle[i]];
    points[i] = v.point;
    if (v.sector == sector) continue;
    EXPECT_EQ(v.sector, (sector + 1) % mesh.grid.sectors) << "a triangle reaches across a line";
    EXPECT_EQ(v.point.u, 0) << "a triangle reaches across a line";
    points[i].u = mesh.grid.sector_steps;
  }
  return points;
}

// Twice the region's area in steps, by Green's theorem over its outline; edges along sector lines
// add nothing.
std::int64_t twice_area(const Region& region) {
  std::int64_t sum = 0;
  for (const auto& sector : region.sectors) {
    for (const RegionEdge& edge : sector) {
      if (!edge.is_outline()) continue;
      const GridPoint from = edge.inside_left ? edge.a : edge.b;
      const GridPoint to = edge.inside_left ? edge.b : edge.a;
      sum -= std::int64_t{to.u - from.u} * (std::int64_t{from.z} + to.z);
    }
  }
  return sum;
}

void expect_triangles_fill(const PlaneMesh& mesh, const Region& region,
                           const std::vector<std::int32_t>& cuts) {
  std::int64_t sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = corners(mesh, triangle);
    const std::int64_t twice = turn(a, b, c);
    ASSERT_GT(twice, 0);
    sum += twice;
    const auto [low, high] = std::minmax({a.z, b.z, c.z});
    const auto cut = std::upper_bound(cuts.begin(), cuts.end(), low);
    ASSERT_TRUE(cut == cuts.end() || *cut >= high) << "a triangle spans the cut at " << *cut;
  }
  EXPECT_EQ(sum, twice_area(region));
}

// Outline edges have one triangle, on their left; all others have two, in opposite directions.
void expect_closed_but_for_the_outline(const PlaneMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> outline;
  for (const OutlineEdge& edge : mesh.outline) {
    ASSERT_TRUE(edge.left == 1 && edge.right == 0);
    ASSERT_TRUE(outline.insert({edge.from, edge.to}).second) << "an outline edge is listed twice";
    ASSERT_EQ(sides.count({edge.from, edge.to}), 1U);
    ASSERT_EQ(sides.count({edge.to, edge.from}), 0U);
  }
  for (const auto& [side, count] : sides) {
    ASSERT_EQ(count, 1);
    const bool has_other = sides.count({side.second, side.first}) == 1;
    ASSERT_NE(has_other, outline.count(side) == 1);
  }
}

void expect_euler_count(const PlaneMesh& mesh, const Region& region) {
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      vertices.insert(t[i]);
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  const long euler = static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
                     static_cast<long>(mesh.triangles.size());
  EXPECT_EQ(euler, 2 * pieces(mesh) - outline_loops(region));
  EXPECT_EQ(vertices.size(), mesh.vertices.size()) << "a vertex belongs to no triangle";
}

void expect_good(const Region& region, const std::vector<std::int32_t>& cuts) {
  const PlaneMesh mesh = triangulate(region);
  ASSERT_NO_FATAL_FAILURE(expect_triangles_fill(mesh, region, cuts));
  ASSERT_NO_FATAL_FAILURE(expect_closed_but_for_the_outline(mesh));
  expect_euler_count(mesh, region);
}

TEST(PlaneMesh, FillsRandomRegionsExactly) {
  constexpr std::uint64_t seed = 5001;
  for (std::uint64_t i = 0; i < 200; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    ASSERT_NO_FATAL_FAILURE(expect_good(unite(plane.pattern, plane.grid, {}, 0.01), {}));
  }
}

// Least distance of a triangle's corner from its far side, in steps.
double lowest_triangle(const PlaneMesh& mesh) {
  double lowest = HUGE_VAL;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = corners(mesh, triangle);
    const auto length = [](GridPoint p, GridPoint q) {
      return std::hypot(static_cast<double>(q.u - p.u), static_cast<double>(q.z - p.z));
    };
    const double longest = std::max({length(a, b), length(b, c), length(c, a)});
    lowest = std::min(lowest, static_cast<double>(turn(a, b, c)) / longest);
  }
  return lowest;
}

double lowest_triangle(const Segment& segment, int sectors) {
  const Pattern pattern = draw_lattice(segment, 0.005);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, pattern.length_mm, sectors);
  return lowest_triangle(triangulate(unite(pattern, grid, {}, 0.01)));
}

// Float32 moves a vertex by less than a quarter of a step (plane_grid.h).
TEST(PlaneMesh, HasNoTrianglesTooLowForFloat32) {
  EXPECT_GT(lowest_triangle(narrow_windows(), 48), 0.5);
  constexpr std::uint64_t seed = 5201;
  for (std::uint64_t i = 0; i < 300; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Segment segment = random_segment(random);
    EXPECT_GT(lowest_triangle(segment, random.whole(12, 80)), 0.5);
  }
}

TEST(PlaneMesh, RespectsTheCuts) {
  constexpr std::uint64_t seed = 5301;
  for (std::uint64_t i = 0; i < 80; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    RandomNumbers random(seed + i);
    std::set<std::int32_t> heights;
    for (int k = random.whole(1, 30); k > 0; --k) {
      heights.insert(random.whole(1, plane.grid.length_steps - 1));
    }
    const std::vector<std::int32_t> cuts(heights.begin(), heights.end());
    ASSERT_NO_FATAL_FAILURE(expect_good(unite(plane.pattern, plane.grid, cuts, 0.01), cuts));
  }
}

TEST(PlaneMesh, FillsASleeveCutBothWays) {
  const std::vector<std::int32_t> cuts{256, 512, 768};
  const Region region =
      unite(on_square_grid({rectangle(0, 0, 4096, 1024)}), square_grid(), cuts, 0.1);
  ASSERT_NO_FATAL_FAILURE(expect_good(region, cuts));
  const PlaneMesh mesh = triangulate(region);
  EXPECT_EQ(mesh.vertices.size(), 4U * 5U);
  EXPECT_EQ(mesh.triangles.size(), 2U * 4U * 4U);
  EXPECT_EQ(mesh.outline.size(), 2U * 4U);
}

TEST(PlaneMesh, CountsPieces) {
  const auto count = [](const std::vector<StepOutline>& outlines) {
    return pieces(triangulate(unite(on_square_grid(outlines), square_grid(), {}, 0.1)));
  };
  EXPECT_EQ(count({}), 0);
  EXPECT_EQ(count({rectangle(0, 0, 4096, 1024)}), 1);
  EXPECT_EQ(count({rectangle(0, 0, 100, 100), rectangle(2000, 0, 100, 100)}), 2);
  EXPECT_EQ(
      count({rectangle(0, 0, 4096, 10), rectangle(0, 20, 4096, 10), rectangle(0, 40, 4096, 10)}),
      3);
  EXPECT_EQ(
      count({rectangle(0, 0, 4096, 10), rectangle(0, 20, 4096, 10), rectangle(500, 0, 10, 1024)}),
      1);
}

TEST(PlaneMesh, IsTheSameEveryTime) {
  const RandomPlane plane = random_plane(5501);
  const PlaneMesh one = triangulate(unite(plane.pattern, plane.grid, {}, 0.01));
  const PlaneMesh two = triangulate(unite(plane.pattern, plane.grid, {}, 0.01));
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_EQ(one.outline, two.outline);
}

}  // namespace
}  // namespace latticast
