// SPDX-License-Identifier: GPL-3.0-or-later
// What the symmetry of a bending design says about its shape.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "model/shape/shape.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

const std::vector<double> irregular = {2, 4, 3.5, 2.5, 3, 2.2, 2.8};  // no symmetry at all

SolverOptions all_unknowns() {
  SolverOptions options;
  options.all_unknowns = true;
  return options;
}

State at(const Segment& segment, double pressure_kpa, const SolverOptions& options = {}) {
  return predict(segment, {}, std::vector<double>{pressure_kpa}, {}, options).states[0].value();
}

double bend_difference(const State& a, const State& b) {
  return std::hypot(a.bend_rad_per_mm[0] - b.bend_rad_per_mm[0],
                    a.bend_rad_per_mm[1] - b.bend_rad_per_mm[1]);
}

TEST(Symmetry, EqualWidthsDoNotBend) {
  for (const double angle : {90.0, 60.0, 120.0}) {
    for (const int count : {2, 3, 8}) {
      const Segment segment = columns(std::vector<double>(count, 2.5), angle);
      EXPECT_EQ(at(segment, 40).bend_magnitude_rad_per_mm(), 0);
      const State forced = at(segment, 40, all_unknowns());
      EXPECT_LT(forced.bend_magnitude_rad_per_mm(), 1e-12) << angle << " " << count;
    }
  }
  Segment mixed = paper_segment({36, 75});
  mixed.lattice->grids.push_back({90, std::vector<double>(6, 2), Horseshoe{85.0 / 32, 180, true}});
  EXPECT_LT(at(mixed, 40, all_unknowns()).bend_magnitude_rad_per_mm(), 1e-12);
}

TEST(Symmetry, ReductionChangesNothing) {
  Segment two_families = columns({2, 4, 3, 3, 4}, 70);
  two_families.lattice->grids.push_back(grid(40, 6, 1));
  for (const Segment& segment :
       {columns(halves(8, 4, 2)), columns(std::vector<double>(8, 2)), columns({2, 4, 3, 3, 4}),
        columns({2, 4, 3, 3, 4}, 60), columns(halves(8, 4, 2), 110), two_families}) {
    const Response response = predict(segment, {}, std::vector<double>{30});
    EXPECT_LT(response.solved.size(), 5U);
    const State& reduced = *response.states[0];
    const State full = at(segment, 30, all_unknowns());
    EXPECT_NEAR(reduced.stretch, full.stretch, 1e-10);
    EXPECT_NEAR(reduced.inner_radius_mm, full.inner_radius_mm, 1e-9);
    EXPECT_NEAR(reduced.twist_rad_per_mm, full.twist_rad_per_mm, 1e-12);
    EXPECT_LT(bend_difference(reduced, full), 1e-12);
    EXPECT_NEAR(reduced.smallest_eigenvalue, full.smallest_eigenvalue, 1e-8);
  }
}

TEST(Symmetry, BendsTowardTheThickerSide) {
  EXPECT_NEAR(at(columns(halves(8, 4, 2)), 40).bend_direction_rad(), 67.5 * degree, 1e-9);
  for (int thick = 0; thick < 7; ++thick) {
    std::vector<double> widths(7, 2);
    widths[thick] = 3;
    const Segment segment = columns(widths);
    const Shape shape(std::vector{segment}, std::vector{at(segment, 30)});
    const Point tip = shape.tip().origin;
    const double toward = 2 * pi * thick / 7;
    EXPECT_GT(std::cos(toward) * tip[0] + std::sin(toward) * tip[1], 0.5);
    EXPECT_NEAR(std::cos(toward) * tip[1] - std::sin(toward) * tip[0], 0, 1e-9);
  }
}

const std::array<Point, 5> wall = {
    {{12, 0, 0}, {0, 17, 30}, {-15, 4, 85}, {3, -13, 60}, {12.5, 12.5, 71}}};

TEST(Symmetry, RotatedDesignGivesTheRotatedShape) {
  for (const double angle : {90.0, 60.0, 128.0}) {
    for (const int places : {1, 3}) {
      std::vector<double> widths = irregular;
      std::rotate(widths.begin(), widths.end() - places, widths.end());
      const Segment first = columns(irregular, angle);
      const Segment second = columns(widths, angle);
      const Shape shape(std::vector{first}, std::vector{at(first, 25)});
      const Shape rotated(std::vector{second}, std::vector{at(second, 25)});
      const double c = std::cos(2 * pi * places / 7);
      const double s = std::sin(2 * pi * places / 7);
      const auto turned = [&](const Point& p) {
        return Point{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
      };
      for (const Point& rest : wall) {
        const Point expected = turned(shape.moved(rest));
        const Point found = rotated.moved(turned(rest));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-8) << angle;
      }
    }
  }
}

TEST(Symmetry, MirroredDesignGivesTheMirroredShape) {
  for (const double angle : {90.0, 60.0, 128.0}) {
    std::vector<double> widths = irregular;
    std::reverse(widths.begin() + 1, widths.end());
    const Segment first = columns(irregular, angle);
    const Segment second = columns(widths, 180 - angle);
    const Shape shape(std::vector{first}, std::vector{at(first, 25)});
    const Shape mirrored(std::vector{second}, std::vector{at(second, 25)});
    for (const Point& rest : wall) {
      const Point expected = shape.moved(rest);
      const Point found = mirrored.moved({rest[0], -rest[1], rest[2]});
      EXPECT_NEAR(found[0], expected[0], 1e-8);
      EXPECT_NEAR(found[1], -expected[1], 1e-8);
      EXPECT_NEAR(found[2], expected[2], 1e-8);
    }
  }
}

TEST(Superimposed, AxialIsExactlyPlainColumns) {
  // With every unknown of the turning frame solved for, nothing is left of the tilt at 90 degrees.
  for (const std::vector<double>& widths : {halves(8, 4, 2), irregular}) {
    const State plain = at(columns(widths), 25);
    const State tilted = at(columns(widths, 90), 25, all_unknowns());
    EXPECT_EQ(tilted.frame_turn_rad_per_mm, 0);
    EXPECT_LT(std::abs(tilted.twist_rad_per_mm), 1e-14);
    EXPECT_NEAR(tilted.stretch, plain.stretch, 1e-11);
    EXPECT_LT(bend_difference(tilted, plain), 1e-13);
  }
}

TEST(Superimposed, GoesOverIntoPlainColumns) {
  const State plain = at(columns(irregular), 25);
  double before = 0;
  for (const double tilt : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const State right = at(columns(irregular, 90 - tilt), 25);
    const State left = at(columns(irregular, 90 + tilt), 25);
    // Twist is odd in the tilt, all else even.
    EXPECT_NEAR(right.twist_rad_per_mm, -left.twist_rad_per_mm, 1e-12);
    EXPECT_NEAR(right.stretch, left.stretch, 1e-10);
    EXPECT_NEAR(right.stretch, plain.stretch, 0.01 * tilt * tilt + 1e-10);
    EXPECT_LT(bend_difference(right, plain), 1e-4 * tilt * tilt + 1e-12);
    EXPECT_LT(right.twist_rad_per_mm, 0);
    if (before != 0) {
      EXPECT_NEAR(before / right.twist_rad_per_mm, 10, 1e-2);
    }
    before = right.twist_rad_per_mm;
  }
}

TEST(Superimposed, EqualWidthsOnlyTwistAndStretch) {
  const Segment segment = columns(std::vector<double>(8, 3), 60);
  const auto response = predict(segment, {}, std::vector<double>{30});
  EXPECT_EQ(response.solved, (std::vector<std::string>{"stretch", "twist", "radius"}));
  const State& state = *response.states[0];
  EXPECT_LT(state.twist_rad_per_mm, -1e-3);
  EXPECT_EQ(state.bend_magnitude_rad_per_mm(), 0);
  // Also with a hair of unevenness, which makes the frame turn and solves all unknowns.
  const State nearly = at(columns({3, 3, 3, 3, 3, 3 + 1e-9, 3, 3}, 60), 30, all_unknowns());
  EXPECT_NEAR(nearly.stretch, state.stretch, 1e-9);
  EXPECT_NEAR(nearly.twist_rad_per_mm, state.twist_rad_per_mm, 1e-10);
  EXPECT_LT(nearly.bend_magnitude_rad_per_mm(), 1e-10);
}

}  // namespace
}  // namespace latticast::testing
