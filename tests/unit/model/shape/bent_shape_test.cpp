// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines and frames of segments that bend and twist, against integration and composition.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "model/shape/shape.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

State curved(double stretch, double twist, double kappa_1, double kappa_2, double turn) {
  State state;
  state.stretch = stretch;
  state.twist_rad_per_mm = twist;
  state.bend_rad_per_mm = {kappa_1, kappa_2};
  state.frame_turn_rad_per_mm = turn;
  state.inner_radius_mm = 13;
  state.outer_radius_mm = 19;
  return state;
}

const std::vector<State> states = {
    curved(1.2, 0, 0.008, 0.003, 0),     curved(1.1, 0.02, -0.01, 0.004, 0),
    curved(1.3, -0.01, 0.006, 0, 0.034), curved(1.3, -0.034, 0.006, 0.002, 0.034),
    curved(1.05, 1e-9, 1e-9, -2e-9, 0),  curved(1, 0.03, 0, 0, 0)};

/// Rows: material directions and tangent, then position; integrated from their derivatives by RK4.
struct Integrated {
  std::array<Point, 3> director{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Point place{};
};

Integrated slope(const State& s, double z, const Integrated& y) {
  const double c = std::cos(s.frame_turn_rad_per_mm * z);
  const double n = std::sin(s.frame_turn_rad_per_mm * z);
  const double k1 = c * s.bend_rad_per_mm[0] - n * s.bend_rad_per_mm[1];
  const double k2 = n * s.bend_rad_per_mm[0] + c * s.bend_rad_per_mm[1];
  Integrated d;
  for (int i = 0; i < 3; ++i) {
    // A fibre toward d1 is longer by kappa_1 per mm: d1' has that along the tangent.
    d.director[0][i] = s.twist_rad_per_mm * y.director[1][i] + k1 * y.director[2][i];
    d.director[1][i] = -s.twist_rad_per_mm * y.director[0][i] + k2 * y.director[2][i];
    d.director[2][i] = -k1 * y.director[0][i] - k2 * y.director[1][i];
    d.place[i] = s.stretch * y.director[2][i];
  }
  return d;
}

Integrated plus(Integrated a, const Integrated& b, double h) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) a.director[j][i] += h * b.director[j][i];
    a.place[i] += h * b.place[i];
  }
  return a;
}

Integrated integrate(const State& s, double length) {
  const int steps = 4000;
  const double h = length / steps;
  Integrated y;
  for (int i = 0; i < steps; ++i) {
    const double z = i * h;
    const Integrated a = slope(s, z, y);
    const Integrated b = slope(s, z + h / 2, plus(y, a, h / 2));
    const Integrated c = slope(s, z + h / 2, plus(y, b, h / 2));
    const Integrated d = slope(s, z + h, plus(y, c, h));
    y = plus(plus(plus(plus(y, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  }
  return y;
}

TEST(BentShape, ClosedFormIsTheIntegral) {
  for (const State& state : states) {
    const Frame frame = frame_along(state, 200);
    const Integrated expected = integrate(state, 200);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(frame.origin[i], expected.place[i], 1e-9);
      for (int j = 0; j < 3; ++j) {
        EXPECT_NEAR(frame.rotation[i][j], expected.director[j][i], 1e-11);
      }
    }
  }
}

TEST(BentShape, FramesAreOrthonormal) {
  for (const State& state : states) {
    const Rotation r = frame_along(state, 500).rotation;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const double dot = r[0][a] * r[0][b] + r[1][a] * r[1][b] + r[2][a] * r[2][b];
        EXPECT_NEAR(dot, a == b ? 1 : 0, 2e-15);
      }
    }
  }
}

TEST(BentShape, ASegmentCutAnywhereIsTheSame) {
  for (const State& state : states) {
    for (const double cut : {1e-6, 13.7, 40.0, 84.9}) {
      Segment whole = paper_segment({36});
      Segment first = whole;
      Segment second = whole;
      first.length_mm = cut;
      second.length_mm = 85 - cut;
      State upper = state;
      const double turn = state.frame_turn_rad_per_mm * cut;
      const auto [x, y] = state.bend_rad_per_mm;
      upper.bend_rad_per_mm = {std::cos(turn) * x - std::sin(turn) * y,
                               std::sin(turn) * x + std::cos(turn) * y};
      const Shape one(std::vector{whole}, std::vector{state});
      const Shape two(std::vector{first, second}, std::vector{state, upper});
      for (const Point& p : {Point{12, 3, 85}, Point{0, -17, 60}, Point{5, 5, 0.5}}) {
        const Point a = one.moved(p);
        const Point b = two.moved(p);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-10);
      }
    }
  }
}

TEST(BentShape, FibresHaveTheStretchOfTheSection) {
  const std::vector<Segment> segments = {paper_segment({36})};
  for (const State& state : states) {
    const Shape shape(segments, std::vector{state});
    const double h = 1e-4;
    const Point a = shape.moved({17 * std::cos(0.8), 17 * std::sin(0.8), h});
    const Point b = shape.moved({17 * std::cos(0.8), 17 * std::sin(0.8), 0});
    const double r = current_radius_mm(12, 17, state.deformation(12));
    const double axial = state.stretch + r * (state.bend_rad_per_mm[0] * std::cos(0.8) +
                                              state.bend_rad_per_mm[1] * std::sin(0.8));
    const double length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / h;
    EXPECT_NEAR(length, std::hypot(axial, state.twist_rad_per_mm * r), 1e-5);
  }
}

TEST(BentShape, BendsTowardMinusKappa) {
  const Shape shape(std::vector{paper_segment({36})}, std::vector{states[0]});
  const Point tip = shape.tip().origin;
  EXPECT_NEAR(std::atan2(tip[1], tip[0]) + 2 * pi, shape.bend_direction_rad(0), 1e-12);
  EXPECT_NEAR(shape.bend_rad(0), 85 * std::hypot(0.008, 0.003), 1e-14);
}

}  // namespace
}  // namespace latticast::testing
