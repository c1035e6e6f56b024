// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/part_overlap.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/geometry/solid/example_bodies.h"

namespace latticast {
namespace {

TriangleMesh box(const Point& low, const Point& size) {
  TriangleMesh mesh = cube();
  for (Point& p : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = low[axis] + size[axis] * p[axis];
  }
  return mesh;
}

/// A tube of chords around z: `sides` of them, the first corner at `turn` sides.
TriangleMesh tube(double inner, double outer, double height, int sides, double turn) {
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i + turn) / sides;
    for (const double r : {inner, outer}) {
      for (const double z : {0.0, height}) {
        mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), z});
      }
    }
  }
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < sides; ++i) {
    const auto here = static_cast<std::uint32_t>(4 * i);
    const auto next = static_cast<std::uint32_t>(4 * ((i + 1) % sides));
    face(here + 2, next + 2, next + 3, here + 3);  // outside
    face(next, here, here + 1, next + 1);          // inside
    face(here + 1, here + 3, next + 3, next + 1);  // top
    face(here, next, next + 2, here + 2);          // bottom
  }
  return mesh;
}

std::vector<PartOverlap> found(const std::vector<TriangleMesh>& meshes) {
  std::vector<MeshObject> objects;
  objects.reserve(meshes.size());
  for (const TriangleMesh& mesh : meshes) objects.push_back({"", mesh});
  const PartOverlaps result = overlapping_parts(objects, std::vector<bool>(objects.size(), true));
  EXPECT_TRUE(result.searched_all);
  return result.found;
}

TEST(PartOverlap, ApartTouchingAndInACavityAreNone) {
  const TriangleMesh left = box({0, 0, 0}, {10, 20, 30});
  EXPECT_TRUE(found({left}).empty());
  EXPECT_TRUE(found({left, box({20, 0, 0}, {10, 20, 30})}).empty());
  EXPECT_TRUE(found({left, box({10, 0, 0}, {10, 20, 30})}).empty());    // a whole face
  EXPECT_TRUE(found({left, box({10, 5, 5}, {5, 5, 5})}).empty());       // part of one
  EXPECT_TRUE(found({left, box({10, 20, 0}, {10, 20, 30})}).empty());   // an edge
  EXPECT_TRUE(found({left, box({10, 20, 30}, {10, 20, 30})}).empty());  // a vertex
  const TriangleMesh hollow =
      together(box({0, 0, 0}, {10, 10, 10}), turned_inside_out(box({2, 2, 2}, {6, 6, 6})));
  EXPECT_TRUE(found({hollow, box({2, 2, 2}, {6, 6, 6})}).empty());
  EXPECT_TRUE(found({hollow, box({3, 3, 3}, {1, 1, 1})}).empty());
}

TEST(PartOverlap, IsMeasured) {
  const auto one = found(
      {box({100, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {10, 20, 30}), box({7, 5, 6}, {10, 10, 10})});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].first, 1U);
  EXPECT_EQ(one[0].second, 2U);
  EXPECT_NEAR(one[0].depth_mm, 3, 1e-9);
  EXPECT_NEAR(one[0].volume_mm3, 300, 3);
  EXPECT_GT(one[0].where[0], 7);
  EXPECT_LT(one[0].where[0], 10);
}

TEST(PartOverlap, OneInsideTheOtherAndTheSameTwice) {
  const TriangleMesh outer = box({0, 0, 0}, {10, 20, 30});
  const auto inside = found({outer, box({1, 1, 1}, {2, 3, 4})});
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_NEAR(inside[0].depth_mm, 2, 1e-9);
  EXPECT_NEAR(inside[0].volume_mm3, 24, 0.3);
  const auto twice = found({outer, outer});
  ASSERT_EQ(twice.size(), 1U);
  EXPECT_NEAR(twice[0].volume_mm3, 6000, 60);
}

/// Bars that cross, without a corner of one inside the other.
TEST(PartOverlap, CrossingBars) {
  const auto crossed = found({box({0, 4, 4}, {10, 2, 2}), box({4, 0, 4}, {2, 10, 2})});
  ASSERT_EQ(crossed.size(), 1U);
  EXPECT_NEAR(crossed[0].depth_mm, 2, 1e-9);
  EXPECT_NEAR(crossed[0].volume_mm3, 8, 0.1);
}

/// A lattice stands on its liner: chords of both reach into each other, by up to 0.05 mm here.
TEST(PartOverlap, ChordsOfACurvedContactAreNone) {
  const TriangleMesh liner = tube(12, 16, 80, 90, 0);
  EXPECT_TRUE(found({liner, tube(16, 18, 80, 63, 0.4)}).empty());
  EXPECT_EQ(found({liner, tube(15.7, 18, 80, 63, 0.4)}).size(), 1U);
}

TEST(PartOverlap, WhatIsNotSoundIsLeftOut) {
  const std::vector<MeshObject> objects{{"", box({0, 0, 0}, {10, 20, 30})},
                                        {"", box({5, 0, 0}, {10, 20, 30})}};
  EXPECT_TRUE(overlapping_parts(objects, {true, false}).found.empty());
}

}  // namespace
}  // namespace latticast
