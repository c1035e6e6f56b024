// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/shape.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

State inflated(const Segment& segment, double pressure_kpa) {
  return predict(segment, {}, std::vector<double>{pressure_kpa}).states[0].value();
}

Point on_tube(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

void expect_point(const Point& found, const Point& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-11);
}

TEST(Shape, RestStateMovesNothing) {
  const std::vector<Segment> segments = {paper_segment({36})};
  const Shape shape(segments, std::vector<State>{inflated(segments[0], 0)});
  for (const Point& p : {on_tube(16, 1.1, 40), on_tube(3, -2, 0), on_tube(18, 3, 85)}) {
    expect_point(shape.moved(p), p);
  }
  EXPECT_EQ(shape.length_mm(), 85);
  EXPECT_EQ(shape.end_rotation_rad(), 0);
  EXPECT_EQ(shape.longest_straight_mm(0, 0.01), std::numeric_limits<double>::infinity());
}

TEST(Shape, OneSegmentFollowsItsState) {
  const std::vector<Segment> segments = {paper_segment({36})};
  const State state = inflated(segments[0], 40);
  const Shape shape(segments, std::vector<State>{state});
  expect_point(
      shape.moved(on_tube(12, 0.4, 50)),
      on_tube(state.inner_radius_mm, 0.4 + 50 * state.twist_rad_per_mm, 50 * state.stretch));
  expect_point(
      shape.moved(on_tube(18, -3.1, 85)),
      on_tube(state.outer_radius_mm, -3.1 + 85 * state.twist_rad_per_mm, 85 * state.stretch));
  expect_point(shape.moved({0, 0, 30}), {0, 0, 30 * state.stretch});
  // Continuous across the bore's wall.
  const Point inside = shape.moved(on_tube(12 - 1e-9, 0.4, 50));
  const Point outside = shape.moved(on_tube(12 + 1e-9, 0.4, 50));
  EXPECT_NEAR(inside[0], outside[0], 1e-7);
}

TEST(Shape, AFieldOfTheMapIsTheDeformationGradient) {
  // Finite differences of the map give F of docs/model.md#coordinates: volume kept in the wall,
  // strands stretched by |F A|.
  const std::vector<Segment> segments = {paper_segment({36})};
  const State state = inflated(segments[0], 40);
  const Shape shape(segments, std::vector<State>{state});
  const double radius = 17;
  const double h = 1e-5;
  const auto difference = [&](const Point& a, const Point& b) {
    return Point{(a[0] - b[0]) / h, (a[1] - b[1]) / h, (a[2] - b[2]) / h};
  };
  const Point e_r = difference(shape.moved(on_tube(radius + h / 2, 0.7, 20)),
                               shape.moved(on_tube(radius - h / 2, 0.7, 20)));
  const Point e_t = difference(shape.moved(on_tube(radius, 0.7 + h / 2 / radius, 20)),
                               shape.moved(on_tube(radius, 0.7 - h / 2 / radius, 20)));
  const Point e_z = difference(shape.moved(on_tube(radius, 0.7, 20 + h / 2)),
                               shape.moved(on_tube(radius, 0.7, 20 - h / 2)));
  const double volume = e_r[0] * (e_t[1] * e_z[2] - e_t[2] * e_z[1]) -
                        e_r[1] * (e_t[0] * e_z[2] - e_t[2] * e_z[0]) +
                        e_r[2] * (e_t[0] * e_z[1] - e_t[1] * e_z[0]);
  EXPECT_NEAR(volume, 1, 1e-7);
  const double c = std::cos(36 * degree);
  const double s = std::sin(36 * degree);
  double square = 0;
  for (int i = 0; i < 3; ++i) square += std::pow(c * e_t[i] + s * e_z[i], 2);
  const double r = current_radius_mm(12, radius, state.deformation(12));
  const double expected =
      std::pow(r / radius * c + state.twist_rad_per_mm * r * s, 2) + std::pow(state.stretch * s, 2);
  EXPECT_NEAR(square, expected, 1e-6);
}

TEST(Shape, ChainAddsLengthsAndTwists) {
  std::vector<Segment> segments = {paper_segment({36}), paper_segment({60}), paper_segment({144})};
  segments[1].length_mm = 50;
  const std::vector<State> states = {inflated(segments[0], 40), inflated(segments[1], 20),
                                     inflated(segments[2], 40)};
  const Shape shape(segments, states);
  const double first = 85 * states[0].twist_rad_per_mm;
  const double second = 50 * states[1].twist_rad_per_mm;
  EXPECT_EQ(shape.z_begin_mm(2), 135);
  EXPECT_EQ(shape.z_end_mm(2), 220);
  EXPECT_NEAR(shape.twist_rad(1), second, 1e-15);
  EXPECT_NEAR(shape.length_mm(),
              85 * states[0].stretch + 50 * states[1].stretch + 85 * states[2].stretch, 1e-11);
  // The mirrored third segment undoes the first one's twist.
  EXPECT_NEAR(shape.end_rotation_rad(), second, 1e-13);
  expect_point(shape.moved(on_tube(12, 0.2, 100)),
               on_tube(states[1].inner_radius_mm, 0.2 + first + 15 * states[1].twist_rad_per_mm,
                       85 * states[0].stretch + 15 * states[1].stretch));
}

TEST(Shape, InterfacesCanBeTakenFromEitherSide) {
  const std::vector<Segment> segments = {paper_segment({36}), paper_segment({60})};
  const std::vector<State> states = {inflated(segments[0], 40), inflated(segments[1], 10)};
  const Shape shape(segments, states);
  const Point end = on_tube(12, 0.3, 85);
  const Point below = shape.moved(end, 0);
  const Point above = shape.moved(end, 1);
  EXPECT_NEAR(std::hypot(below[0], below[1]), states[0].inner_radius_mm, 1e-11);
  EXPECT_NEAR(std::hypot(above[0], above[1]), states[1].inner_radius_mm, 1e-11);
  EXPECT_NEAR(below[2], above[2], 1e-11);
  EXPECT_NEAR(std::atan2(below[1], below[0]), std::atan2(above[1], above[0]), 1e-12);
  EXPECT_EQ(shape.moved(end), above);
  EXPECT_THROW(shape.moved(end, 2), std::out_of_range);
}

TEST(Shape, LongestStraightKeepsTheChordError) {
  const std::vector<Segment> segments = {paper_segment({36})};
  const State state = inflated(segments[0], 40);
  const Shape shape(segments, std::vector<State>{state});
  const double length = shape.longest_straight_mm(0, 0.01);
  const Point a = shape.moved(on_tube(18, 0, 10));
  const Point b = shape.moved(on_tube(18, 0, 10 + length));
  const Point middle = shape.moved(on_tube(18, 0, 10 + length / 2));
  const double error = std::sqrt(std::pow(middle[0] - (a[0] + b[0]) / 2, 2) +
                                 std::pow(middle[1] - (a[1] + b[1]) / 2, 2) +
                                 std::pow(middle[2] - (a[2] + b[2]) / 2, 2));
  EXPECT_NEAR(error, 0.01, 1e-12);
  EXPECT_TRUE(std::isfinite(shape.longest_straight_mm(0, 1000)));
}

TEST(Shape, NeedsOneStateForEachSegment) {
  const std::vector<Segment> segments = {paper_segment({36})};
  EXPECT_THROW(Shape(segments, {}), std::invalid_argument);
  EXPECT_THROW(Shape({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace latticast::testing
