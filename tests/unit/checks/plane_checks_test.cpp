// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/plane_checks.h"

#include <gtest/gtest.h>

#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/tube_solids.h"
#include "tests/unit/checks/checked_designs.h"

namespace latticast {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double side(PlanePoint a, PlanePoint b) {
  return std::hypot(a.u - b.u, a.z - b.z);
}

TEST(InscribedWidth, IsTheIncircleOfTriangles) {
  const unsigned seed = 20261;
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    std::vector<PlanePoint> p(3);
    for (PlanePoint& q : p) q = {uniform(random, -5, 5), uniform(random, -5, 5)};
    const double area = 0.5 * std::abs((p[1].u - p[0].u) * (p[2].z - p[0].z) -
                                       (p[1].z - p[0].z) * (p[2].u - p[0].u));
    const double around = side(p[0], p[1]) + side(p[1], p[2]) + side(p[2], p[0]);
    const double width = inscribed_width_mm(p, 1e9, 1e-6);
    EXPECT_NEAR(width, 4 * area / around, 1e-6) << "seed " << seed << ", triangle " << i;
    EXPECT_LE(width, 4 * area / around + 1e-12);
  }
}

// The largest circle of a corner of two arms of width 1 touches both outer walls and the inner
// corner: (1 - r) sqrt(2) = r.
TEST(InscribedWidth, SeesMoreThanTheArmsOfAnAngle) {
  const std::vector<PlanePoint> corner = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  const double radius = std::numbers::sqrt2 / (1 + std::numbers::sqrt2);
  EXPECT_NEAR(inscribed_width_mm(corner, 1e9, 1e-7), 2 * radius, 1e-7);
}

TEST(InscribedWidth, StopsWhereItIsEnoughAndBearsDegeneratePolygons) {
  const std::vector<PlanePoint> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_GE(inscribed_width_mm(square, 1, 0.1), 1);
  EXPECT_EQ(inscribed_width_mm({}, 1, 0.1), 0);
  EXPECT_EQ(inscribed_width_mm({{0, 0}, {1, 1}}, 1, 0.1), 0);
  EXPECT_NEAR(inscribed_width_mm({{0, 0}, {1, 1}, {2, 2}}, 1, 0.1), 0, 1e-9);
}

// A long triangular gap: material on the left of a clockwise outline.
TEST(WedgeLength, OfStraightSidesHasAClosedForm) {
  const unsigned seed = 20262;
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    const double first = uniform(random, 0, 6.28);
    const double angle = uniform(random, 0.05, 1.4);
    const double stretch = uniform(random, 0.8, 1.2);
    const double width = uniform(random, 0.1, 1);
    const PlanePoint a{100 * std::cos(first), 100 * std::sin(first)};
    const PlanePoint b{100 * std::cos(first + angle), 100 * std::sin(first + angle)};
    const double opening = std::remainder(
        std::atan2(b.z, stretch * b.u) - std::atan2(a.z, stretch * a.u), 2 * test_pi);
    const Outline gap{{{0, 0}, b, a}, 0};
    EXPECT_NEAR(wedge_length_mm(gap, 0, width, stretch), width / (2 * std::sin(0.5 * opening)),
                1e-9)
        << "seed " << seed << ", wedge " << i;
    const Outline solid{{{0, 0}, a, b}, 0};
    EXPECT_EQ(wedge_length_mm(solid, 0, width, stretch), 0);
  }
}

TEST(WedgeLength, OfASliverIsHalfItsOutlineAtMost) {
  const Outline sliver{{{0, 0}, {10, 0.05}, {10, 0}}, 0};
  EXPECT_NEAR(wedge_length_mm(sliver, 0, 0.4, 1), 0.5 * (10 + 0.05 + std::hypot(10, 0.05)), 1e-9);
}

LatticePlane plane_of(const Segment& segment) {
  LatticeDrawing drawing(segment);
  return lattice_plane(drawing);
}

UnitedLattice united(const Segment& segment) {
  return {segment, 1, plane_of(segment)};
}

// Strips cover the same share of every level, so that rings and strips overlap by the product.
TEST(LatticePlane, HasTheAreaAndTheCellsOfRingsAndStrips) {
  const Segment segment = twisting_segment();
  const LatticePlane plane = plane_of(segment);
  const double strips = 8 * 2 / std::sin(36 * test_pi / 180) / (2 * test_pi * 17);
  const double rings = 8 * 2.0 / 85;
  EXPECT_NEAR(plane.area_mm2, 2 * test_pi * 17 * 85 * (1 - (1 - strips) * (1 - rings)), 0.05);
  ASSERT_EQ(plane.parts.size(), 1U);
  EXPECT_EQ(std::count_if(plane.outlines.begin(), plane.outlines.end(),
                          [](const Outline& outline) { return outline.is_cell(); }),
            7 * 8);
  for (const Outline& outline : plane.outlines) {
    EXPECT_TRUE(!outline.is_cell() || outline.points.size() == 4);
  }
}

TEST(LatticePlane, NamesLooseParts) {
  Segment rings = twisting_segment();
  rings.lattice->grids.clear();
  const LatticePlane bands = plane_of(rings);
  ASSERT_EQ(bands.parts.size(), 8U);
  EXPECT_EQ(bands.outlines.size(), 16U);
  for (const LatticePart& part : bands.parts) {
    EXPECT_NEAR(part.area_mm2, 2 * test_pi * 17 * 2, 1e-2);
    const double from_ring = std::remainder(part.place.z - 1, 83.0 / 7);
    EXPECT_LE(std::abs(from_ring), 1.0);
  }
  Segment strips = twisting_segment();
  strips.lattice->rings.reset();
  EXPECT_EQ(plane_of(strips).parts.size(), 8U);
}

TEST(LatticePlane, HasAsManyPartsAsTheSolid) {
  const unsigned seed = 20263;
  std::mt19937 random(seed);
  for (int i = 0; i < 12; ++i) {
    Segment segment = twisting_segment();
    Lattice& lattice = *segment.lattice;
    if (i % 3 == 0) lattice.rings.reset();
    lattice.fillet_mm = i % 4 == 1 ? 0.3 : 0;
    lattice.grids[0].angle_deg = uniform(random, 20, 160);
    if (i % 2 == 0) lattice.grids.push_back({uniform(random, 20, 160), {1.5, 1.0, 2.0}, {}});
    const Solid solid = lattice_solid(segment, {0.05});
    EXPECT_EQ(plane_of(segment).parts.size(), static_cast<std::size_t>(solid.pieces))
        << "seed " << seed << ", design " << i;
  }
}

TEST(LongestBridge, LiesUnderARingBetweenStrands) {
  const Segment segment = twisting_segment();
  const double free = 2 * test_pi * 17 / 8 - 2 / std::sin(36 * test_pi / 180);
  EXPECT_NEAR(longest_bridge(united(segment)).length_mm, free * 18 / 17, 1e-3);
}

TEST(LongestBridge, OfARingInTheAirIsItsWholeTurn) {
  Segment segment = twisting_segment();
  segment.lattice->grids.clear();
  const Bridge bridge = longest_bridge(united(segment));
  EXPECT_NEAR(bridge.length_mm, 2 * test_pi * 18, 1e-6);
  EXPECT_GT(bridge.middle.z, 2);
  segment.lattice->rings = Rings{std::nullopt, 85.0, 2};
  EXPECT_NEAR(longest_bridge(united(segment)).length_mm, 2 * test_pi * 18, 1e-6);
}

TEST(LongestBridge, ThereIsNoneOnTheBed) {
  Segment segment = twisting_segment();
  segment.lattice->rings.reset();
  EXPECT_EQ(longest_bridge(united(segment)).length_mm, 0);
}

TEST(PlaneChecks, NamesTheWorstOpeningAndCountsThem) {
  Segment segment = twisting_segment();
  segment.lattice->grids = {{30, std::vector<double>(8, 2.0), {}},
                            {120, std::vector<double>(8, 2.0), {}}};
  const UnitedLattice lattice = united(segment);
  const auto cells = [&](double limit) {
    return with_code(plane_checks(lattice, {false, 0.1, limit, true, true}), "cell-too-small");
  };
  const auto found = cells(0.4);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(cells(*found[0].value - 2e-3).empty());
  ASSERT_EQ(cells(*found[0].value + 5e-3).size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::note);
  ASSERT_TRUE(found[0].place);
  EXPECT_GE(found[0].place->theta_deg, 0);
  EXPECT_LT(found[0].place->theta_deg, 360);
  segment.lattice->fillet_mm = *remedy_value(found[0], "fillet");
  EXPECT_TRUE(
      with_code(plane_checks(united(segment), {false, 0.1, 0.4, true, true}), "cell-too-small")
          .empty());
}

TEST(PlaneChecks, FilletsTakeTheWedgesAway) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].angle_deg = 10;
  segment.lattice->grids[0].widths_mm.assign(2, 2.0);
  const LatticeUse use{false, 0.8, 0.4, true, true};
  const auto found = with_code(plane_checks(united(segment), use), "acute-corner");
  ASSERT_EQ(found.size(), 1U);
  const double angle = std::atan(std::tan(10 * test_pi / 180) * 17 / 18);
  EXPECT_NEAR(*found[0].value, 0.4 / (2 * std::sin(0.5 * angle)), 2e-3);
  segment.lattice->fillet_mm = *remedy_value(found[0], "fillet");
  EXPECT_TRUE(with_code(plane_checks(united(segment), use), "acute-corner").empty());
}

TEST(PlaneChecks, NamesEightLoosePartsAndCountsTheRest) {
  Segment segment = twisting_segment();
  segment.lattice->rings.reset();
  segment.lattice->grids[0].widths_mm.assign(20, 1.0);
  const auto found =
      with_code(plane_checks(united(segment), {false, 0.8, 0.4, true, true}), "loose-part");
  ASSERT_EQ(found.size(), 8U);
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_NE(found[7].message.find("11 more"), std::string::npos) << found[7].message;
  segment = twisting_segment();
  segment.lattice->grids.clear();
  for (const CheckFinding& part :
       with_code(plane_checks(united(segment), {false, 0.8, 0.4, true, true}), "loose-part")) {
    EXPECT_EQ(part.severity, Severity::warning);
  }
}

}  // namespace
}  // namespace latticast
