// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/pattern.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/geometry/pattern/strand_outline.h"

namespace latticast {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

double total_area(const Pattern& pattern) {
  double sum = 0;
  for (const Strand& strand : pattern.strands) sum += area(strand);
  return sum;
}

// Liner 12 to 16, layer 16 to 18, 85 long.
Segment example_segment() {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, std::nullopt, {}};
  return segment;
}

Grid family(double angle_deg, std::vector<double> widths_mm) {
  return {angle_deg, std::move(widths_mm), StraightPath{}};
}

// Distance between the two long sides of a strip.
double width_square_to_itself(const Strand& strip) {
  const PlanePoint& a = strip.outline[0];
  const PlanePoint& b = strip.outline[1];
  const PlanePoint& d = strip.outline[3];
  const double along_u = d.u - a.u;
  const double along_z = d.z - a.z;
  return std::abs((b.u - a.u) * along_z - (b.z - a.z) * along_u) / std::hypot(along_u, along_z);
}

TEST(Pattern, StrandAreasAddUpToTheClosedForm) {
  Segment segment = example_segment();
  segment.lattice->rings = Rings{8, std::nullopt, 2};
  segment.lattice->grids = {family(36, std::vector<double>(8, 2.0)), family(144, {1, 1.5, 0.5})};
  const Pattern pattern = draw_lattice(segment, 0.005);
  const double circumference = 2 * std::numbers::pi * 17;
  EXPECT_DOUBLE_EQ(pattern.circumference_mm, circumference);
  EXPECT_DOUBLE_EQ(pattern.length_mm, 85);
  EXPECT_EQ(pattern.strands.size(), 8U + 8U + 3U);
  const double strips = 85 * (8 * 2 + 3) / std::sin(36 * radians_per_degree);
  EXPECT_NEAR(total_area(pattern), 8 * 2 * circumference + strips, 1e-9);
}

TEST(Pattern, StripsKeepTheirWidthAndAngleAndSpacing) {
  const std::vector<double> widths{2, 0.5, 1, 3, 0.25};
  for (const double angle : {0.5, 10.0, 36.0, 89.999, 90.0, 90.001, 144.0, 179.5}) {
    SCOPED_TRACE(angle);
    Segment segment = example_segment();
    segment.lattice->grids = {family(angle, widths)};
    const Pattern pattern = draw_lattice(segment, 0.005);
    ASSERT_EQ(pattern.strands.size(), widths.size());
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const Strand& strip = pattern.strands[i];
      ASSERT_EQ(strip.outline.size(), 4U);
      EXPECT_GT(area(strip), 0);  // counter-clockwise
      EXPECT_NEAR(width_square_to_itself(strip), widths[i], 1e-9 * widths[i]);
      const double start = 0.5 * (strip.outline[0].u + strip.outline[1].u);
      EXPECT_NEAR(start, static_cast<double>(i) * pattern.circumference_mm / 5, 1e-9);
      const double drift = strip.outline[3].u - strip.outline[0].u;
      EXPECT_NEAR(std::atan2(85, drift) / radians_per_degree, angle, 1e-9);
      EXPECT_EQ(strip.outline[0].z, 0);
      EXPECT_EQ(strip.outline[1].z, 0);
      EXPECT_EQ(strip.outline[2].z, 85);
      EXPECT_EQ(strip.outline[3].z, 85);
    }
  }
}

TEST(Pattern, AxialColumnsAreExactlyAxial) {
  Segment segment = example_segment();
  segment.lattice->grids = {family(90, std::vector<double>(7, 1.0))};
  for (const Strand& strip : draw_lattice(segment, 0.005).strands) {
    EXPECT_EQ(strip.outline[0].u, strip.outline[3].u);
    EXPECT_EQ(strip.outline[1].u, strip.outline[2].u);
  }
}

TEST(Pattern, SupplementaryAnglesMirrorEachOther) {
  Segment segment = example_segment();
  segment.lattice->grids = {family(25, {2}), family(155, {2})};
  const Pattern pattern = draw_lattice(segment, 0.005);
  const auto& rising = pattern.strands[0].outline;
  const auto& falling = pattern.strands[1].outline;
  EXPECT_NEAR(rising[2].u, -falling[3].u, 1e-9);
  EXPECT_NEAR(rising[3].u, -falling[2].u, 1e-9);
}

TEST(Pattern, RingsGoOnceAroundAndEndExactlyOnTheSegmentsEnds) {
  Segment segment = example_segment();
  segment.length_mm = 0.7;  // 0.7 - 0.05 + 0.05 is not 0.7 in binary
  segment.lattice->rings = Rings{3, std::nullopt, 0.1};
  const Pattern pattern = draw_lattice(segment, 0.005);
  ASSERT_EQ(pattern.strands.size(), 3U);
  EXPECT_EQ(pattern.strands.front().outline[0].z, 0);
  EXPECT_EQ(pattern.strands.back().outline[2].z, 0.7);
  for (const Strand& ring : pattern.strands) {
    EXPECT_NEAR(area(ring), pattern.circumference_mm * 0.1, 1e-12);
    EXPECT_EQ(ring.outline[1].u - ring.outline[0].u, pattern.circumference_mm);
  }
}

TEST(Pattern, SleeveCoversThePlane) {
  const Pattern pattern = draw_sleeve(14, 85);
  ASSERT_EQ(pattern.strands.size(), 1U);
  EXPECT_DOUBLE_EQ(pattern.circumference_mm, 28 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(total_area(pattern), 28 * std::numbers::pi * 85);
}

TEST(Pattern, HorseshoesAreDrawnBesideStraightStripsAndRings) {
  Segment segment = example_segment();
  segment.lattice->rings = Rings{8, std::nullopt, 2};
  segment.lattice->grids = {family(36, {2}), family(90, {1, 2, 1, 2})};
  segment.lattice->grids[1].path = Horseshoe{85.0 / 32, 150, true};
  const double radius = 85.0 / 32 / std::sin(75 * radians_per_degree);
  std::get<Horseshoe>(segment.lattice->grids[1].path).radius_mm = radius;
  const double circumference = 2 * std::numbers::pi * 17;
  const double arcs = 16 * radius * 150 * radians_per_degree * (1 + 2 + 1 + 2);
  const double strips = 85 * 2 / std::sin(36 * radians_per_degree);
  const Pattern pattern = draw_lattice(segment, 0.005);
  EXPECT_NEAR(total_area(pattern), 8 * 2 * circumference + strips + arcs, 1e-9);
  // Strand j starts at its place around the tube.
  for (int j = 0; j < 4; ++j) {
    const double start = j * circumference / 4;
    bool found = false;
    for (const Strand& strand : pattern.strands) {
      for (const PlanePoint& p : strand.outline) {
        found |= p.z == 0 && std::abs(p.u - start) < segment.lattice->grids[1].widths_mm[j];
      }
    }
    EXPECT_TRUE(found) << "strand " << j;
  }
}

}  // namespace
}  // namespace latticast
