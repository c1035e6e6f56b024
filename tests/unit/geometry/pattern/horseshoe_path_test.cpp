// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/horseshoe_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/geometry/pattern/strand_outline.h"

namespace latticast {
namespace {

// A column that closes with `arcs` arcs on its length.
HorseshoeColumn closed_column(double angle_deg, double arc_deg, bool alternate, int arcs,
                              double width_over_radius, double length = 40) {
  const double chord = length / std::sin(radians(angle_deg)) / arcs;
  const double radius = 0.5 * chord / std::sin(0.5 * radians(arc_deg));
  return {{radius, arc_deg, alternate}, 3.0, angle_deg, width_over_radius * radius, length};
}

bool holds(const DrawnStrand& drawn, PlanePoint p) {
  return std::any_of(drawn.links.begin(), drawn.links.end(),
                     [&](const Strand& arc) { return holds(arc, p); });
}

// Distance from the endless chain's centre line, in complex numbers: the chord line is the real
// axis, arcs bulge to negative imaginary numbers first.
double distance_to_chain(const HorseshoeColumn& column, PlanePoint p) {
  const double half = 0.5 * radians(column.shape.arc_deg);
  const double radius = column.shape.radius_mm;
  const double chord = 2 * radius * std::sin(half);
  const double turn = radians(column.angle_deg);
  const double du = p.u - column.start_u_mm;
  const double s = du * std::cos(turn) + p.z * std::sin(turn);
  const double t = du * std::sin(turn) - p.z * std::cos(turn);
  double nearest = HUGE_VAL;
  for (int arc = static_cast<int>(s / chord) - 40; arc < s / chord + 40; ++arc) {
    const double side = column.shape.alternate && arc % 2 != 0 ? -1 : 1;
    const double across = side * t + radius * std::cos(half);
    const double along = s - (arc + 0.5) * chord;
    const double direction = std::clamp(std::atan2(along, across), -half, half);
    nearest = std::min(nearest, std::hypot(along - radius * std::sin(direction),
                                           across - radius * std::cos(direction)));
  }
  return nearest;
}

TEST(HorseshoePath, ClosesAtTheNearestWholeNumberOfArcs) {
  // 85 mm in 16 arcs of 180 degrees: R = 85/32.
  const HorseshoeColumn column{{2.656, 180, true}, 0, 90, 1, 85};
  EXPECT_NEAR(closing_radius_mm(column), 85.0 / 32, 1e-14);
  const HorseshoeColumn tilted{{2.656, 180, true}, 0, 30, 1, 85};
  EXPECT_NEAR(arcs_on_segment(tilted), 2 * 85 / (2 * 2.656), 1e-12);
  const HorseshoeColumn shorter_than_an_arc{{100, 90, true}, 0, 90, 1, 2};
  EXPECT_NEAR(closing_radius_mm(shorter_than_an_arc), std::numbers::sqrt2, 1e-14);
}

TEST(HorseshoePath, OutlinesEncloseTheAreaOfTheArcs) {
  // A cut through a joint takes from one arc what it leaves of the next: the chain is symmetric
  // about every joint. Chords enclose what the circle does, at every flatness.
  for (const double arc : {20.0, 45.0, 90.0, 150.0, 180.0}) {
    for (const double ratio : {0.05, 0.3, 1.0, 1.9}) {
      for (const int arcs : {1, 2, 7, 16}) {
        for (const double flatness : {0.02, 0.005, 0.0005}) {
          const HorseshoeColumn column = closed_column(90, arc, true, arcs, ratio);
          SCOPED_TRACE(testing::Message() << arc << " " << ratio << " " << arcs << " " << flatness);
          const double scaled = flatness * column.width_mm;
          const DrawnStrand drawn = draw_strand(column, scaled);
          EXPECT_TRUE(drawn.in_one_piece);
          double sum = 0;
          for (const Strand& strand : drawn.links) {
            EXPECT_GT(area(strand), 0);
            sum += area(strand);
          }
          const double expected = arcs * column.shape.radius_mm * radians(arc) * column.width_mm;
          // Where the cut runs along a strand, tips lower than the flatness are left out.
          const double tips = 4 * scaled * column.width_mm;
          EXPECT_LE(sum, expected * (1 + 1e-12));
          EXPECT_GE(sum, expected * (1 - 1e-12) - tips);
        }
      }
    }
  }
}

TEST(HorseshoePath, OutlinesFollowTheTrueArcs) {
  constexpr unsigned seed = 4101;
  std::mt19937_64 engine(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  int inside = 0;
  int outside = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const bool alternate = trial % 2 == 0;
    const double angle = trial % 5 == 0 ? 90 : between(25, 155);
    const double arc = between(20, alternate ? 230 : 180);
    HorseshoeColumn column = closed_column(angle, arc, alternate, 2 + trial % 11, 1);
    const double radius = column.shape.radius_mm;
    const double room = arc > 180 ? 4 * std::sin(0.5 * radians(arc)) - 2 : 1.9;
    column.width_mm = radius * between(0.02, 0.95 * std::min(room, 1.9));
    const double flatness = column.width_mm * between(0.001, 0.1);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << " trial " << trial << ": angle " << angle << " arc " << arc
                 << " R " << radius << " w " << column.width_mm << (alternate ? "" : " one-sided"));
    const DrawnStrand drawn = draw_strand(column, flatness);
    const double reach = 2 * radius + column.width_mm;
    for (int i = 0; i < 800; ++i) {
      const double z = between(0, column.length_mm);
      const PlanePoint p{column.start_u_mm + z / std::tan(radians(angle)) +
                             between(-2, 2) * radius / std::sin(radians(angle)),
                         z};
      const double depth = 0.5 * column.width_mm - distance_to_chain(column, p);
      if (std::abs(depth) < 1.01 * flatness) continue;
      const bool drawn_there = holds(drawn, p);
      ++(drawn_there ? inside : outside);
      if (drawn_there) {
        ASSERT_GT(depth, 0) << p.u << " " << p.z;
      }
      // Only near the ends may parts of the chain be left out.
      const bool near_end = z < reach || z > column.length_mm - reach;
      if (!drawn_there && !near_end) {
        ASSERT_LT(depth, 0) << p.u << " " << p.z;
      }
      const bool never_loose = angle == 90 && arc < 180;
      if (!drawn_there && never_loose) {
        ASSERT_LT(depth, 0) << p.u << " " << p.z;
      }
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 2000);
}

TEST(HorseshoePath, NeighbouringArcsShareTheirCornersBitForBit) {
  for (const double angle : {90.0, 63.0, 137.0}) {
    const HorseshoeColumn column = closed_column(angle, 150, true, 9, 0.4);
    const DrawnStrand drawn = draw_strand(column, 0.01);
    int shared = 0;
    for (std::size_t i = 0; i < drawn.links.size(); ++i) {
      for (std::size_t j = i + 1; j < drawn.links.size(); ++j) {
        for (const PlanePoint& p : drawn.links[i].outline) {
          for (const PlanePoint& q : drawn.links[j].outline) shared += p.u == q.u && p.z == q.z;
        }
      }
    }
    EXPECT_GE(shared, 2 * 8);  // two at every joint inside
  }
}

TEST(HorseshoePath, IsCutLevelAndStaysOnTheSegment) {
  for (const double angle : {30.0, 90.0, 150.0}) {
    for (const double arc : {60.0, 180.0, 220.0}) {
      const HorseshoeColumn column = closed_column(angle, arc, true, 12, 0.3);
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (const Strand& strand : draw_strand(column, 0.003).links) {
        for (const PlanePoint& p : strand.outline) {
          low = std::min(low, p.z);
          high = std::max(high, p.z);
        }
      }
      EXPECT_EQ(low, 0);
      EXPECT_EQ(high, column.length_mm);
    }
  }
}

TEST(HorseshoePath, SaysWhenTheCutPartsTheStrand) {
  EXPECT_TRUE(draw_strand(closed_column(60, 180, true, 8, 0.2), 0.01).in_one_piece);
  // Four half circles at 10 degrees: the third one dips from the middle to below the near end.
  EXPECT_FALSE(draw_strand(closed_column(10, 180, true, 4, 0.2), 0.01).in_one_piece);
}

TEST(HorseshoePath, DistanceOfNeighboursIsTheirSpacingWhereArcsNest) {
  // Axial columns in phase run parallel: nowhere closer than where they are steepest, and two
  // columns shifted along u by d have points exactly d apart.
  const HorseshoeColumn straightish = closed_column(90, 20, true, 8, 0.1);
  const double steepest = std::cos(radians(10));
  EXPECT_NEAR(centre_distance_mm(straightish, 1.0), steepest, 2e-3);
  const HorseshoeColumn half_circles = closed_column(90, 180, true, 8, 0.1);
  const double radius = half_circles.shape.radius_mm;
  // Circles of equal radius beside each other, 10 R apart: from right bulge to left bulge.
  EXPECT_LT(centre_distance_mm(half_circles, 10 * radius), 10 * radius);
}

TEST(HorseshoePath, DistanceOfNeighboursAgreesWithBruteForce) {
  constexpr unsigned seed = 4201;
  std::mt19937_64 engine(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int trial = 0; trial < 100; ++trial) {
    const bool alternate = trial % 2 == 0;
    const double angle = between(20, 160);
    const HorseshoeColumn column = closed_column(angle, between(20, 200), alternate, 40, 0.2);
    const double radius = column.shape.radius_mm;
    // As far as a strand is wide at most.
    const double spacing = radius * between(0.1, 6) / std::sin(radians(angle));
    SCOPED_TRACE(testing::Message() << "seed " << seed << " trial " << trial);
    HorseshoeColumn neighbour = column;
    neighbour.start_u_mm += spacing;
    double brute = HUGE_VAL;
    const double half = 0.5 * radians(column.shape.arc_deg);
    const double chord = chord_mm(column.shape);
    for (int arc = 20; arc < 22; ++arc) {
      const double side = alternate && arc % 2 != 0 ? -1 : 1;
      for (int i = 0; i <= 500; ++i) {
        const double direction = -half + 2 * half * i / 500;
        const double s = (arc + 0.5) * chord + radius * std::sin(direction);
        const double t = side * radius * (std::cos(direction) - std::cos(half));
        const double turn = radians(angle);
        const PlanePoint p{column.start_u_mm + s * std::cos(turn) + t * std::sin(turn),
                           s * std::sin(turn) - t * std::cos(turn)};
        brute = std::min(brute, distance_to_chain(neighbour, p));
      }
    }
    const double found = centre_distance_mm(column, spacing);
    if (std::min(found, brute) < 2 * radius) {
      EXPECT_NEAR(found, brute, 2e-3 * radius);
    }
  }
}

}  // namespace
}  // namespace latticast
