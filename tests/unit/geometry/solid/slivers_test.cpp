// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/slivers.h"

#include <gtest/gtest.h>

#include "design/read_design.h"
#include "geometry/solid/flat_pattern.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {
namespace {

Strand rectangle(double left, double right, double low, double high) {
  return {{{left, low}, {right, low}, {right, high}, {left, high}}};
}

Pattern pattern_of(std::vector<Strand> strands) {
  return {.circumference_mm = 100, .length_mm = 50, .strands = std::move(strands)};
}

Region united(const Pattern& pattern) {
  return unite(pattern, make_flat_grid(pattern.circumference_mm, pattern.length_mm), {}, 0.01);
}

int pieces_of(const Pattern& pattern) {
  return pieces(triangulate(united(pattern)));
}

TEST(NearPlaces, AreWhereOutlinesComeNearerThanTheWidth) {
  const auto gap = [](double wide) {
    return pattern_of({rectangle(10, 20, 0, 20), rectangle(10, 20, 20 + wide, 50)});
  };
  EXPECT_TRUE(near_places(united(gap(0.02)), 0.01).empty());
  const std::vector<PlanePoint> near = near_places(united(gap(0.005)), 0.01);
  ASSERT_FALSE(near.empty());
  for (const PlanePoint& place : near) EXPECT_NEAR(place.z, 20, 0.01);
}

// A gap that runs across the seam of the plane.
TEST(NearPlaces, AreFoundAcrossTheSeam) {
  const Pattern pattern =
      pattern_of({rectangle(80, 99.998, 10, 20), rectangle(100.002, 120, 10, 20)});
  EXPECT_FALSE(near_places(united(pattern), 0.01).empty());
  ASSERT_EQ(slivers_of(pattern, 0.01, false).size(), 1U);
}

TEST(NearPlaces, AreNoCorners) {
  const Pattern cross = pattern_of({rectangle(10, 20, 0, 50), rectangle(0, 40, 20, 25)});
  EXPECT_TRUE(near_places(united(cross), 0.01).empty());
  EXPECT_TRUE(slivers_of(cross, 0.01, true).empty());
}

TEST(Slivers, GapsAreClosed) {
  const Pattern open = pattern_of({rectangle(10, 20, 0, 20), rectangle(10, 20, 20.005, 50)});
  EXPECT_EQ(pieces_of(open), 2);
  const std::vector<Sliver> slivers = slivers_of(open, 0.01, false);
  ASSERT_EQ(slivers.size(), 1U);
  EXPECT_TRUE(slivers[0].is_gap);
  EXPECT_NEAR(slivers[0].middle.u, 15, 0.01);
  EXPECT_NEAR(slivers[0].reach_mm, 10, 0.02);
  const Pattern closed = without_slivers(open, slivers, 0.01);
  EXPECT_EQ(pieces_of(closed), 1);
  EXPECT_NEAR(area_mm2(united(closed)), 500, 0.01);
  EXPECT_NEAR(closed.error.distance_mm, 0.005, 1e-12);
}

TEST(Slivers, NecksAreParted) {
  const Pattern joined = pattern_of({{{{10, 10},
                                       {20, 10},
                                       {20, 15},
                                       {20.2, 15},
                                       {20.2, 10},
                                       {30, 10},
                                       {30, 20},
                                       {20.2, 20},
                                       {20.2, 15.004},
                                       {20, 15.004},
                                       {20, 20},
                                       {10, 20}}}});
  EXPECT_EQ(pieces_of(joined), 1);
  EXPECT_TRUE(slivers_of(joined, 0.01, false).empty());
  const std::vector<Sliver> slivers = slivers_of(joined, 0.01, true);
  ASSERT_EQ(slivers.size(), 1U);
  EXPECT_FALSE(slivers[0].is_gap);
  EXPECT_EQ(pieces_of(without_slivers(joined, slivers, 0.01)), 2);
}

// Arcs that graze rings: mesh and flat pattern have the same pieces and holes at any flatness.
TEST(Slivers, AreTheSameInAllThatIsMade) {
  const ReadResult read = read_design_file(
      std::filesystem::path(LATTICAST_SOURCE_DIR) / "tests/checks/gap-closed/rejected.toml",
      built_in_materials());
  ASSERT_TRUE(read.ok());
  const Segment& segment = read.design.segments.front();
  LatticeDrawing drawing(segment, 0.01);
  EXPECT_EQ(drawing.slivers().size(), 32U);
  EXPECT_EQ(drawing.near_places().size(), 32U);
  const Solid rest = lattice_solid(drawing, {.tolerance_mm = 0.01});
  const Solid fine = lattice_solid(drawing, {.tolerance_mm = 0.003, .twist_rad_per_mm = 0.001});
  EXPECT_EQ(fine.genus, rest.genus);
  EXPECT_EQ(fine.pieces, rest.pieces);
  const FlatPattern flat = flat_pattern(drawing, 0.01);
  LatticeDrawing as_drawn(segment);
  EXPECT_TRUE(as_drawn.slivers().empty());
  EXPECT_NEAR(flat.area_mm2, flat_pattern(as_drawn, 0.01).area_mm2, 32 * 0.14 * 0.01);
}

}  // namespace
}  // namespace latticast
