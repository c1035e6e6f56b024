// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/flat_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/flat_pattern_rules.h"

namespace latticast {
namespace {

Segment segment_of(std::vector<Grid> grids) {
  Segment segment = example_segment();
  segment.lattice->rings.reset();
  segment.lattice->grids = std::move(grids);
  return segment;
}

std::size_t holes_of(const FlatPattern& sheet) {
  std::size_t holes = 0;
  for (const FlatPiece& piece : sheet.pieces) holes += piece.holes.size();
  return holes;
}

TEST(FlatPattern, OfRingsIsARectangleEach) {
  Segment segment = example_segment();
  segment.lattice->grids.clear();
  const FlatPattern sheet = flat_pattern(segment, 0.01);
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
  ASSERT_EQ(sheet.pieces.size(), 8U);
  const double pitch = (85.0 - 2) / 7;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::vector<PlanePoint>& ring = sheet.pieces[i].outer;
    ASSERT_EQ(ring.size(), 4U);
    EXPECT_EQ(ring[0].u, 0);
    EXPECT_EQ(ring[2].u, sheet.circumference_mm);
    EXPECT_NEAR(ring[0].z, i * pitch, 1.5e-5);
    EXPECT_NEAR(ring[2].z, i * pitch + 2, 1.5e-5);
  }
  EXPECT_EQ(sheet.radius_mm, 17);
  EXPECT_NEAR(sheet.area_mm2, 8 * 2 * 2 * std::numbers::pi * 17, 1e-2);
}

TEST(FlatPattern, SlitsTheStrandAtThetaZeroIntoTwoHalves) {
  const Segment segment = segment_of({{90, std::vector<double>(8, 2.0), StraightPath{}}});
  const FlatPattern sheet = flat_pattern(segment, 0.01);
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
  ASSERT_EQ(sheet.pieces.size(), 9U);
  EXPECT_EQ(sheet.pieces.front().outer.front().u, 0);
  EXPECT_NEAR(sheet.pieces.front().outer[1].u, 1, 2e-5);
  EXPECT_NEAR(sheet.pieces.back().outer.front().u, sheet.circumference_mm - 1, 2e-5);
  EXPECT_EQ(sheet.pieces.back().outer[1].u, sheet.circumference_mm);
}

TEST(FlatPattern, OfTheExampleHasTheOutlinesThatTheTubeHasLessTheSlitOnes) {
  const FlatPattern sheet = flat_pattern(example_segment(), 0.01);
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(example_segment(), sheet, 0.01));
  EXPECT_EQ(sheet.pieces.size(), 1U);
  // 56 windows; the slit opens at least one in each of seven bays, at most three.
  EXPECT_LE(holes_of(sheet), 49U);
  EXPECT_GE(holes_of(sheet), 35U);
  // The solid's volume by hand (LatticeSolid, same example), over height and radii.
  EXPECT_NEAR(sheet.area_mm2, 7174.5268 / 2, 1e-5 * 3587);
}

TEST(FlatPattern, OfStrandsWiderThanTheirSpacingIsTheRectangle) {
  for (const double angle : {36.0, 90.0, 150.0}) {
    const Segment segment = segment_of({{angle, std::vector<double>(4, 40.0), StraightPath{}}});
    const FlatPattern sheet = flat_pattern(segment, 0.01);
    ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
    ASSERT_EQ(sheet.pieces.size(), 1U);
    EXPECT_TRUE(sheet.pieces[0].holes.empty());
    ASSERT_EQ(sheet.pieces[0].outer.size(), 4U);
    EXPECT_EQ(sheet.pieces[0].outer[2].u, 2 * std::numbers::pi * 17);
    EXPECT_EQ(sheet.pieces[0].outer[2].z, 85);
    EXPECT_NEAR(sheet.area_mm2, 2 * std::numbers::pi * 17 * 85, 1e-9 * sheet.area_mm2);
  }
}

TEST(FlatPattern, OfASingleStrandIsAsManyPartsAsItCrossesTheSlit) {
  for (const double angle : {0.5, 36.0, 144.0, 179.5}) {
    SCOPED_TRACE(angle);
    const Segment segment = segment_of({{angle, {0.8}, StraightPath{}}});
    const FlatPattern sheet = flat_pattern(segment, 0.01);
    ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
    // The middle line starts on the slit; parts of both its ends lie on the slit's other side.
    const double turns =
        85 / std::abs(std::tan(angle * std::numbers::pi / 180)) / (2 * std::numbers::pi * 17);
    EXPECT_NEAR(static_cast<double>(sheet.pieces.size()), turns + 1.5, 1);
    EXPECT_NEAR(sheet.area_mm2, 85 * 0.8 / std::sin(angle * std::numbers::pi / 180),
                2e-3 * sheet.area_mm2);
  }
}

TEST(FlatPattern, OfHundredsOfTurnsOfTwoFamiliesKeepsItsTopology) {
  Segment segment = segment_of({{0.5, {0.3}, StraightPath{}}, {179.5, {0.3}, StraightPath{}}});
  segment.length_mm = 300;
  const FlatPattern sheet = flat_pattern(segment, 0.01);
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
  EXPECT_GT(holes_of(sheet), 300U);
}

TEST(FlatPattern, HoldsArcsAndFilletsWithinTheTolerance) {
  Segment segment = example_segment();
  for (const bool alternate : {true, false}) {
    for (const double fillet : {0.0, 0.5}) {
      SCOPED_TRACE(fillet);
      segment.lattice->grids = {
          {90, std::vector<double>(6, 1.2), Horseshoe{85.0 / 32, 180, alternate}}};
      segment.lattice->fillet_mm = fillet;
      const FlatPattern sheet = flat_pattern(segment, 0.01);
      ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.01));
      // And 1.5 steps of the grid along either axis.
      EXPECT_LE(sheet.error.distance_mm, 0.01 + 1e-4);
      EXPECT_GE(sheet.error.distance_mm, 0.005);
    }
  }
}

// Both families are as wide along u as a sixth of the way around: the cells' left tips lie on the
// twelfths of it, one of them on the slit.
TEST(FlatPattern, JoinsWhatASlitThroughATipWouldLeaveInAPoint) {
  const double angle = 50;
  Segment segment = segment_of({});
  const double width = 2 * std::numbers::pi * 17 / 6 * std::sin(angle * std::numbers::pi / 180);
  segment.lattice->grids = {{angle, std::vector<double>(2, width), StraightPath{}},
                            {180 - angle, std::vector<double>(3, width), StraightPath{}}};
  const FlatPattern sheet = flat_pattern(segment, 0.05);
  ASSERT_GE(tips_on_slit(flat_region(segment, sheet, 0.05)), 1) << "no tip lies on the slit";
  EXPECT_GE(sheet.error.area_mm2, 2 * 0.05 * 0.05);
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, 0.05));
}

TEST(FlatPattern, OfRingsThatDoNotFitIsEmpty) {
  Segment segment = segment_of({});
  segment.lattice->rings = Rings{std::nullopt, 400, 2};
  EXPECT_TRUE(flat_pattern(segment, 0.01).pieces.empty());
}

TEST(FlatPattern, RefusesStrandsThinnerThanTheGridHolds) {
  const Segment segment = segment_of({{90, {1e-4}, StraightPath{}}});
  EXPECT_THROW(flat_pattern(segment, 1e-5), GeometryError);
}

}  // namespace
}  // namespace latticast
