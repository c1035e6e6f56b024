// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/polygon/face_list.h"

namespace latticast {
namespace {

using Outline = std::vector<std::array<double, 2>>;

const Outline l_shape{{0, 0}, {20, 0}, {20, 5}, {5, 5}, {5, 20}, {0, 20}};
const Outline t_shape{{0, 10}, {5, 10}, {5, 0}, {10, 0}, {10, 10}, {15, 10}, {15, 15}, {0, 15}};
const Outline chevron{{0, 0}, {10, 5}, {0, 10}, {3, 5}};
const Outline with_straight_corners{{0, 0},  {5, 0},  {10, 0}, {10, 10},
                                    {7, 10}, {3, 10}, {0, 10}, {0, 5}};
/// A square with a square hole, joined by a side that is walked there and back.
const Outline keyhole{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0},
                      {3, 3}, {3, 7},  {7, 7},   {7, 3},  {3, 3}};

Outline star(int tips) {
  Outline outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 == 0 ? 10 : 3;
    outline.push_back(
        {r * std::cos(std::numbers::pi * i / tips), r * std::sin(std::numbers::pi * i / tips)});
  }
  return outline;
}

double area_of(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

/// In a plane of its own, or turned around.
std::vector<Point> in_space(const Outline& outline, const std::array<Point, 2>& axes) {
  std::vector<Point> points;
  for (const auto& [x, y] : outline) {
    Point point{};
    for (std::size_t i = 0; i < 3; ++i) point[i] = 7 + x * axes[0][i] + y * axes[1][i];
    points.push_back(point);
  }
  return points;
}

/// Twice the area, as a vector.
Point normal(const Point& a, const Point& b, const Point& c) {
  Point result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t u = (i + 1) % 3;
    const std::size_t v = (i + 2) % 3;
    result[i] = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  }
  return result;
}

/// Every side of the outline is a side of one triangle, every other side one of two, in opposite
/// directions, and no triangle faces the other way or is empty: the areas tell the rest.
void expect_covers(const std::vector<Point>& points, double area) {
  const std::vector<Triangle> triangles = polygon_triangles(points);
  EXPECT_EQ(triangles.size(), points.size() - 2);
  std::map<std::pair<Point, Point>, int> sides;
  Point sum{};
  double total = 0;
  for (const Triangle& t : triangles) {
    const Point n = normal(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += 0.5 * n[i];
      ++sides[{points[t[i]], points[t[(i + 1) % 3]]}];
      --sides[{points[t[(i + 1) % 3]], points[t[i]]}];
    }
    total += 0.5 * std::hypot(n[0], n[1], n[2]);
    EXPECT_GT(std::hypot(n[0], n[1], n[2]), 0);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& next = points[(i + 1) % points.size()];
    --sides[{points[i], next}];
    ++sides[{next, points[i]}];
  }
  for (const auto& [ends, count] : sides) EXPECT_EQ(count, 0);
  EXPECT_NEAR(total, area, 1e-9 * area);
  EXPECT_NEAR(std::hypot(sum[0], sum[1], sum[2]), area, 1e-9 * area);
}

TEST(PolygonTriangles, CoverConcaveFacesInAnyPlane) {
  const double half = std::sqrt(0.5);
  const std::vector<std::array<Point, 2>> planes{
      {{{1, 0, 0}, {0, 1, 0}}},  {{{0, 1, 0}, {1, 0, 0}}},       {{{0, 1, 0}, {0, 0, 1}}},
      {{{0, 0, 1}, {-1, 0, 0}}}, {{{half, half, 0}, {0, 0, 1}}}, {{{half, 0, half}, {0, 1, 0}}}};
  for (const Outline& outline :
       {l_shape, t_shape, chevron, with_straight_corners, keyhole, star(5), star(60)}) {
    for (std::size_t first = 0; first < outline.size(); ++first) {
      Outline turned = outline;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                  turned.end());
      for (const auto& plane : planes) expect_covers(in_space(turned, plane), area_of(outline));
    }
  }
}

TEST(PolygonTriangles, QuadranglesPartAtTheirFirstCorner) {
  const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}};
  EXPECT_EQ(polygon_triangles(square), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(polygon_triangles(std::span(square).first(3)), (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PolygonTriangles, CornersThatComeTwiceInARowCountOnce) {
  const std::vector<Point> square{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(polygon_triangles(square).size(), 2U);
}

TEST(PolygonTriangles, OfWhatHasNoInsideUseEveryCorner) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<Point>& points :
       {std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},  // crosses itself
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}},  // a line
        std::vector<Point>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},               // a point
        std::vector<Point>{{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {1, 3, 0}, {1, -2, 0}, {4, -2, 0}},
        std::vector<Point>{{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        std::vector<Point>{{0, 0, 0}, {HUGE_VAL, 0, 0}, {1, 1, 0}, {0, 1, 0}}}) {
    std::vector<int> used(points.size());
    for (const Triangle& t : polygon_triangles(points)) {
      for (const std::uint32_t corner : t) used.at(corner) = 1;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 1), static_cast<std::ptrdiff_t>(points.size()));
  }
}

/// Stars with random radii, and combs whose teeth stand on straight sides, at float32.
TEST(PolygonTriangles, CoverRandomFaces) {
  constexpr unsigned seed = 90;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return static_cast<float>(std::uniform_real_distribution(low, high)(random));
  };
  for (int trial = 0; trial < 300; ++trial) {
    Outline outline;
    const int count = 4 + static_cast<int>(random() % 60);
    for (int i = 0; i < count && trial % 2 == 0; ++i) {
      const double angle = 2 * std::numbers::pi * (double{number(0, 0.5)} + i) / count;
      const double r = number(1, 20);
      outline.push_back(
          {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle))});
    }
    for (int i = 0; i < count && trial % 2 == 1; ++i) {
      outline.push_back({i * 2.0, 0});
    }
    for (int i = count; i-- > 0 && trial % 2 == 1;) {
      outline.push_back({i * 2.0, i % 3 == 0 ? 5.0 : number(1, 30)});
    }
    SCOPED_TRACE("trial " + std::to_string(trial));
    expect_covers(in_space(outline, {{{1, 0, 0}, {0, 1, 0}}}), area_of(outline));
  }
}

TEST(FaceList, KeepsTheOrderOfItsFaces) {
  const std::vector<Point> points{{0, 0, 0}, {10, 5, 0}, {0, 10, 0}, {3, 5, 0}, {9, 9, 9}};
  FaceList faces;
  faces.add(Triangle{4, 0, 1});
  faces.add(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  faces.add(Triangle{4, 1, 2});
  const std::vector<Triangle> triangles = std::move(faces).triangles(points);
  ASSERT_EQ(triangles.size(), 4U);
  EXPECT_EQ(triangles[0], (Triangle{4, 0, 1}));
  EXPECT_EQ(triangles[3], (Triangle{4, 1, 2}));
  for (std::size_t i = 1; i < 3; ++i) {  // both at the corner that looks inward
    EXPECT_EQ(std::count(triangles[i].begin(), triangles[i].end(), 3U), 1);
    EXPECT_EQ(std::count(triangles[i].begin(), triangles[i].end(), 1U), 1);
  }
}

}  // namespace
}  // namespace latticast
