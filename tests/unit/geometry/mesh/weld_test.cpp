// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/weld.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

namespace latticast {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The same by an ordered map; no NaN.
TriangleMesh weld_plainly(const TriangleMesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> places;
  TriangleMesh welded;
  std::vector<std::uint32_t> index;
  for (const Point& p : mesh.vertices) {
    const auto x = static_cast<float>(p[0]);
    const auto y = static_cast<float>(p[1]);
    const auto z = static_cast<float>(p[2]);
    const auto next = static_cast<std::uint32_t>(welded.vertices.size());
    const auto [place, is_new] = places.try_emplace({x, y, z}, next);
    if (is_new) {
      welded.vertices.push_back({x, y, z});
    }
    index.push_back(place->second);
  }
  for (const Triangle& t : mesh.triangles) {
    welded.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  }
  return welded;
}

TEST(Weld, AnEmptyMeshStaysEmpty) {
  EXPECT_TRUE(weld({}).vertices.empty());
  EXPECT_TRUE(weld({}).triangles.empty());
}

TEST(Weld, MakesEqualVerticesOneInOrderOfAppearance) {
  const TriangleMesh soup{{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}},
                          {{0, 1, 2}, {5, 4, 3}}};
  const TriangleMesh welded = weld(soup);
  EXPECT_EQ(welded.vertices, (std::vector<Point>{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(welded.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 1, 2}}));
}

TEST(Weld, BothZerosAreOne) {
  const TriangleMesh welded = weld({{{-0.0, 0.0, -0.0}, {0.0, -0.0, 0.0}, {1, 0, 0}}, {{0, 2, 1}}});
  ASSERT_EQ(welded.vertices.size(), 2U);
  for (const double x : welded.vertices[0]) {
    EXPECT_FALSE(std::signbit(x));
  }
  EXPECT_EQ(welded.triangles[0], (Triangle{0, 1, 0})) << "a collapsed triangle stays";
}

TEST(Weld, RoundsToFloat32) {
  const double close = 1 + 1e-9;
  const double apart = 1 + 2e-7;
  const double too_small = 1e-60;
  const TriangleMesh welded = weld({{{1, 0, 0}, {close, too_small, 0}, {apart, 0, 0}}, {}});
  ASSERT_EQ(welded.vertices.size(), 2U);
  EXPECT_EQ(welded.vertices[1][0], static_cast<double>(static_cast<float>(apart)));
}

TEST(Weld, NeighbouringFloatsStayApart) {
  const float next = std::nextafter(16.0F, 17.0F);
  EXPECT_EQ(weld({{{16, 0, 0}, {next, 0, 0}, {0, 16, 0}, {0, 0, 16}}, {}}).vertices.size(), 4U);
  EXPECT_EQ(weld({{{1e-45F, 0, 0}, {0, 0, 0}}, {}}).vertices.size(), 2U);
}

TEST(Weld, NanEqualsNothingAndInfinityItself) {
  const TriangleMesh welded =
      weld({{{nan, 0, 0}, {nan, 0, 0}, {infinity, 0, 0}, {infinity, 0, 0}, {-infinity, 0, 0}},
            {{0, 1, 3}}});
  EXPECT_EQ(welded.vertices.size(), 4U);
  EXPECT_EQ(welded.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_TRUE(std::isnan(welded.vertices[1][0]));
}

TEST(Weld, ManyNanVerticesTakeLinearTime) {
  // In one chain of the hash table this would be 4e10 comparisons.
  const TriangleMesh mesh{std::vector<Point>(300000, Point{0, nan, 0}), {}};
  EXPECT_EQ(weld(mesh).vertices.size(), 300000U);
}

TEST(SameTriangles, AreToldByTheirCornersNotByTheirNumbers) {
  const TriangleMesh shared{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const TriangleMesh apart{{{9, 9, 9}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}},
                           {{4, 2, 1}, {1, 2, 3}}};
  EXPECT_TRUE(same_triangles(shared, apart));
  EXPECT_TRUE(same_triangles({}, {}));
  TriangleMesh turned = apart;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(same_triangles(shared, turned));
  TriangleMesh moved = apart;
  moved.vertices[3][2] = 0x1p-20;
  EXPECT_FALSE(same_triangles(shared, moved));
  TriangleMesh fewer = apart;
  fewer.triangles.pop_back();
  EXPECT_FALSE(same_triangles(shared, fewer));
  EXPECT_FALSE(same_triangles(fewer, shared));
  const TriangleMesh unknown{{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_FALSE(same_triangles(unknown, unknown));
}

TEST(Weld, TellsWhetherASurfaceHasARim) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_TRUE(is_closed(mesh));
  mesh.triangles[3] = {1, 3, 2};  // turned over
  EXPECT_FALSE(is_closed(mesh));
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_TRUE(is_closed({}));
}

TEST(Weld, AgreesWithAnOrderedMap) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const int values : {2, 7, 60}) {
    std::uniform_int_distribution<int> coordinate(-values, values);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 90000; i += 3) {
      for (int corner = 0; corner < 3; ++corner) {
        mesh.vertices.push_back(
            {coordinate(random) * 0.1, coordinate(random) * 17.0, coordinate(random) * -0.0});
      }
      mesh.triangles.push_back({i, i + 1, i + 2});
    }
    const TriangleMesh expected = weld_plainly(mesh);
    const TriangleMesh welded = weld(mesh);
    EXPECT_EQ(welded.vertices, expected.vertices);
    EXPECT_EQ(welded.triangles, expected.triangles);
  }
}

}  // namespace
}  // namespace latticast
