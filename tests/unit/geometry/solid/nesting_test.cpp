// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/nesting.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/geometry/solid/example_bodies.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

// Winding number of a closed mesh around a point, from the solid angles of its triangles
// (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983). Not a number on the surface.
double winding_by_solid_angles(const TriangleMesh& mesh, const Point& p) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    std::array<Point, 3> r{};
    std::array<double, 3> length{};
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) r[i][axis] = mesh.vertices[t[i]][axis] - p[axis];
      length[i] = std::hypot(r[i][0], r[i][1], r[i][2]);
    }
    const auto dot = [&](int i, int j) {
      return r[i][0] * r[j][0] + r[i][1] * r[j][1] + r[i][2] * r[j][2];
    };
    const double volume = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
                          r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
                          r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    const double cosine = length[0] * length[1] * length[2] + dot(0, 1) * length[2] +
                          dot(1, 2) * length[0] + dot(2, 0) * length[1];
    if (std::abs(volume) < 1e-12 && cosine < 1e-12) return NAN;
    sum += 2 * std::atan2(volume, cosine);
  }
  return sum / (4 * std::numbers::pi);
}

std::vector<std::uint32_t> numbers(std::size_t from, std::size_t to) {
  std::vector<std::uint32_t> all;
  for (std::size_t i = from; i < to; ++i) all.push_back(static_cast<std::uint32_t>(i));
  return all;
}

// What is around a speck at p, which is too small to meet the body.
int around_speck(const TriangleMesh& body, const Point& p) {
  const TriangleMesh both = together(body, placed(tetrahedron(), 1e-9, p));
  const std::size_t split = body.triangles.size();
  return surrounding_winding(both, {numbers(0, split), numbers(split, both.triangles.size())})[1];
}

TEST(SurroundingWinding, AgreesWithSolidAngles) {
  constexpr std::uint64_t seed = 2001;
  int inside = 0;
  const std::vector<TriangleMesh> bodies{
      cube(), torus(), turned_inside_out(torus(9, 4)),
      together(placed(cube(), 4, {-2, -2, -2}),
               turned_inside_out(placed(cube(), 2, {-1, -1, -1})))};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    RandomNumbers random(seed + b);
    for (int i = 0; i < 400; ++i) {
      // Every other point on a grid of eighths, level with corners and in line with edges.
      Point p;
      for (double& x : p) x = i % 2 == 0 ? random.whole(-32, 32) / 8.0 : random.between(-4, 4);
      const double expected = winding_by_solid_angles(bodies[b], p);
      if (std::isnan(expected)) continue;
      ASSERT_EQ(around_speck(bodies[b], p), static_cast<int>(std::round(expected)))
          << "seed " << seed + b << ", point " << i << ": " << p[0] << " " << p[1] << " " << p[2];
      inside += std::abs(expected) > 0.5;
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(SurroundingWinding, OfBodiesSideBySideIsZero) {
  const TriangleMesh row = together(cube(), placed(cube(), 1, {2, 0, 0}));
  EXPECT_EQ(surrounding_winding(row, {numbers(0, 12), numbers(12, 24)}), (std::vector<int>{0, 0}));
  EXPECT_TRUE(surrounding_winding({}, {}).empty());
}

}  // namespace
}  // namespace latticast
