// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/region.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/plane_mesh.h"
#include "tests/unit/geometry/solid/random_patterns.h"
#include "tests/unit/geometry/solid/square_patterns.h"

namespace latticast {
namespace {

constexpr double closing_mm = 0.1;  // ten steps of the square grid, raised to sixteen by unite

Region square_region(const std::vector<StepOutline>& outlines) {
  return unite(on_square_grid(outlines), square_grid(), {}, closing_mm);
}

void expect_two_edges_at_every_vertex(const Region& region) {
  std::map<NamedVertex, int> degree;
  for (const auto& [a, b] : outline_edges(region)) {
    ++degree[a];
    ++degree[b];
  }
  for (const auto& [vertex, count] : degree) {
    ASSERT_EQ(count, 2) << "sector " << vertex.first << ", u " << vertex.second.u << ", z "
                        << vertex.second.z;
  }
}

void expect_shape(const std::vector<StepOutline>& outlines, int expected_pieces, int expected_loops,
                  double area, double slack) {
  const Region region = square_region(outlines);
  ASSERT_NO_FATAL_FAILURE(expect_two_edges_at_every_vertex(region));
  EXPECT_EQ(pieces(triangulate(region)), expected_pieces);
  EXPECT_EQ(outline_loops(region), expected_loops);
  EXPECT_NEAR(area_mm2(region), area, slack);
}

// In mm^2, from steps.
double square_area(double steps) {
  return steps * 1e-4;
}

TEST(Region, OfOneRectangleIsExact) {
  expect_shape({rectangle(100, 200, 300, 400)}, 1, 1, square_area(300 * 400), 1e-12);
}

TEST(Region, OverTheSeamIsWhole) {
  expect_shape({rectangle(-500, 100, 1000, 50)}, 1, 1, square_area(1000 * 50), 1e-12);
}

TEST(Region, OfRectanglesOnSectorLinesIsWhole) {
  expect_shape({rectangle(1024, 100, 1024, 50), rectangle(2048, 100, 1024, 50)}, 1, 1,
               square_area(2048 * 50), 1e-12);
}

TEST(Region, OverlapCountsOnce) {
  expect_shape({rectangle(100, 100, 300, 300), rectangle(200, 200, 300, 300)}, 1, 1,
               square_area(2 * 300 * 300 - 200 * 200), 1e-12);
  expect_shape({rectangle(100, 100, 300, 300), rectangle(100, 100, 300, 300)}, 1, 1,
               square_area(300 * 300), 1e-12);
}

TEST(Region, SharedSidesVanish) {
  expect_shape(
      {rectangle(100, 100, 100, 100), rectangle(200, 100, 100, 100), rectangle(100, 200, 200, 70)},
      1, 1, square_area(200 * 170), 1e-12);
}

TEST(Region, OfAFrameHasItsHole) {
  expect_shape({rectangle(100, 100, 2000, 50), rectangle(100, 800, 2000, 50),
                rectangle(100, 100, 50, 750), rectangle(2050, 100, 50, 750)},
               1, 2, square_area(2000.0 * 750 - 1900 * 650), 1e-12);
}

TEST(Region, StrandsThatWindOverThemselvesCountOnce) {
  // One strip, three turns around a tube of 4096 steps, as wide as a turn rises: it fills the
  // middle.
  expect_shape({{{0, 0}, {4096, 0}, {4 * 4096, 1024}, {3 * 4096, 1024}}}, 1, 2,
               square_area(4096.0 * 1024), 1e-9);
}

TEST(Region, SleevesRingsAndPatchesCountTheirOutlines) {
  const auto sleeve = rectangle(0, 0, 4096, 1024);
  const auto ring = rectangle(0, 300, 4096, 100);
  const auto patch = rectangle(500, 700, 100, 100);
  expect_shape({sleeve}, 1, 2, square_area(4096.0 * 1024), 1e-9);
  expect_shape({ring}, 1, 2, square_area(4096.0 * 100), 1e-9);
  expect_shape({ring, patch}, 2, 3, square_area(4096.0 * 100 + 100 * 100), 1e-9);
  expect_shape({ring, rectangle(0, 0, 4096, 100), patch}, 3, 5,
               square_area(4096.0 * 200 + 100 * 100), 1e-9);
}

TEST(Region, OfNothingIsEmpty) {
  const Region region = square_region({});
  EXPECT_EQ(area_mm2(region), 0);
  EXPECT_EQ(outline_loops(region), 0);
  EXPECT_TRUE(triangulate(region).triangles.empty());
}

struct Touch {
  const char* where;
  std::vector<StepOutline> outlines;
  int closed_pieces;
  int closed_loops;
};

// Material that meets in single points only.
std::vector<Touch> touches() {
  const auto corner_pair = [](std::int32_t u, std::int32_t z) {
    return std::vector<StepOutline>{rectangle(u - 100, z - 100, 100, 100),
                                    rectangle(u, z, 100, 100)};
  };
  return {
      {"inside a sector", corner_pair(500, 500), 1, 1},
      {"on a sector line", corner_pair(1024, 500), 1, 1},
      {"on the seam", corner_pair(0, 500), 1, 1},
      {"on the seam, one turn on", corner_pair(4096, 500), 1, 1},
      {"at z = 0", {{{300, 0}, {500, 0}, {300, 200}}, {{500, 0}, {700, 0}, {700, 200}}}, 1, 1},
      {"at z = L",
       {{{300, 824}, {500, 1024}, {300, 1024}}, {{700, 824}, {700, 1024}, {500, 1024}}},
       1,
       1},
      {"at z = 0 on the seam",
       {{{-200, 0}, {0, 0}, {-200, 200}}, {{0, 0}, {200, 0}, {200, 200}}},
       1,
       1},
      {"at a corner and a side's middle",
       {rectangle(400, 400, 200, 200), {{500, 600}, {550, 700}, {450, 700}}},
       1,
       1},
      {"in four places around a hole",
       {rectangle(400, 400, 100, 100), rectangle(500, 500, 100, 100), rectangle(600, 400, 100, 100),
        rectangle(500, 300, 100, 100)},
       1,
       2},
      {"of three corners in one point",
       {{{500, 500}, {600, 480}, {600, 520}},
        {{500, 500}, {480, 600}, {450, 600}},
        {{500, 500}, {420, 400}, {460, 400}}},
       1,
       1},
      {"of a ring's edge and an arrow from both sides",
       {rectangle(0, 300, 4096, 100),
        {{2048, 400}, {2148, 500}, {1948, 500}},
        {{2048, 300}, {1948, 200}, {2148, 200}}},
       1,
       2},
      {"of a hole and the outside",
       {{{300, 300}, {700, 300}, {500, 350}},
        {{300, 300}, {500, 350}, {300, 700}},
        {{500, 350}, {700, 300}, {700, 700}, {300, 700}, {500, 690}}},
       1,
       2},
  };
}

TEST(Region, ClosesMaterialThatTouchesInAPoint) {
  for (const Touch& touch : touches()) {
    SCOPED_TRACE(touch.where);
    const Region region = square_region(touch.outlines);
    ASSERT_NO_FATAL_FAILURE(expect_two_edges_at_every_vertex(region));
    EXPECT_EQ(pieces(triangulate(region)), touch.closed_pieces);
    EXPECT_EQ(outline_loops(region), touch.closed_loops);
    double strands = 0;
    for (const StepOutline& outline : touch.outlines) {
      strands += area_mm2(square_region({outline}));
    }
    // The strands do not overlap, so that what is added are the diamonds alone.
    EXPECT_GE(area_mm2(region), strands);
    EXPECT_LE(area_mm2(region), strands + 4 * square_area(2 * 16 * 16));
  }
}

TEST(Region, KeepsTwoVerticesApartThatOnlyComeClose) {
  const std::vector<StepOutline> two{rectangle(400, 400, 100, 100), rectangle(502, 502, 100, 100)};
  expect_shape(two, 2, 2, square_area(2 * 100 * 100), 1e-12);
}

TEST(Region, OfAxialColumnsAndRingsAlone) {
  Segment segment;
  segment.length_mm = 50;
  segment.liner = {8, 2, {}};
  segment.lattice = Lattice{2, {}, Rings{3, std::nullopt, 2}, {}};
  Pattern pattern = draw_lattice(segment, 0.005);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, 50, 40);
  const double around = pattern.circumference_mm;
  EXPECT_NEAR(area_mm2(unite(pattern, grid, {}, 0.01)), 3 * 2 * around, 4 * around * 2e-5);

  segment.lattice->rings.reset();
  segment.lattice->grids = {{90, {1, 2, 3, 2}, StraightPath{}}};
  const Region columns = unite(draw_lattice(segment, 0.005), grid, {}, 0.01);
  EXPECT_NEAR(area_mm2(columns), 8 * 50, 8 * 50 * 2e-5);
  EXPECT_EQ(outline_loops(columns), 4);
}

TEST(Region, OfTheExampleHasTheAreaCountedByHand) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, Rings{8, std::nullopt, 2}, {}};
  segment.lattice->grids = {{36, std::vector<double>(8, 2.0), StraightPath{}}};
  const Pattern pattern = draw_lattice(segment, 0.005);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, 85, 79);
  const Region region = unite(pattern, grid, {}, 0.01);
  const double sine = std::sin(36 * std::numbers::pi / 180);
  const double rings = 8 * 2 * pattern.circumference_mm;
  const double strips = 8 * 85 * 2 / sine;
  const double overlaps = 8 * 8 * 2 * 2 / sine;
  const double by_hand = rings + strips - overlaps;
  EXPECT_NEAR(area_mm2(region), by_hand, 1e-5 * by_hand);
  EXPECT_NEAR(by_hand * (18 * 18 - 16 * 16) / (2 * 17), 7174.5268, 1e-4);
  // Eight rings bound seven rows of eight windows.
  EXPECT_EQ(outline_loops(region), 2 + 7 * 8);
}

TEST(Region, LinePointsSayWhatIsMaterialOnEitherSide) {
  // Material before line 1 from 100 to 300, after it from 200 to 400.
  const Region region =
      square_region({rectangle(924, 100, 100, 200), rectangle(1024, 200, 100, 200)});
  const std::vector<LinePoint> points = line_points(region, 1);
  ASSERT_EQ(points.size(), 4U);
  const std::vector<std::array<int, 3>> expected{
      {100, 1, 0}, {200, 1, 1}, {300, 0, 1}, {400, 0, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(points[i].z, expected[i][0]);
    EXPECT_EQ(points[i].inside_before, expected[i][1] == 1);
    EXPECT_EQ(points[i].inside_after, expected[i][2] == 1);
  }
  EXPECT_TRUE(line_points(region, 0).empty());
  EXPECT_TRUE(line_points(region, 3).empty());
}

// The same pattern with every corner on a grid point, so that moving it by whole steps is exact.
Pattern moved_by_sectors(const Pattern& pattern, const PlaneGrid& grid, int sectors) {
  Pattern moved = pattern;
  for (Strand& strand : moved.strands) {
    for (PlanePoint& p : strand.outline) {
      const double steps = std::round(p.u / grid.u_step_mm) + double(sectors) * grid.sector_steps;
      p.u = steps * grid.u_step_mm;
    }
  }
  return moved;
}

void expect_same(const std::vector<RegionEdge>& a, const std::vector<RegionEdge>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].a, b[i].a);
    ASSERT_EQ(a[i].b, b[i].b);
    ASSERT_EQ(a[i].inside_left, b[i].inside_left);
    ASSERT_EQ(a[i].inside_right, b[i].inside_right);
  }
}

TEST(Region, TurnsWithItsPatternByWholeSectors) {
  constexpr std::uint64_t seed = 9001;
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const int count = plane.grid.sectors;
    const int shift = 1 + static_cast<int>(i) % (3 * count);
    const Region here = unite(moved_by_sectors(plane.pattern, plane.grid, 0), plane.grid, {}, 0.01);
    const Region there =
        unite(moved_by_sectors(plane.pattern, plane.grid, shift), plane.grid, {}, 0.01);
    for (int c = 0; c < count; ++c) {
      ASSERT_NO_FATAL_FAILURE(expect_same(here.sectors[c], there.sectors[(c + shift) % count]))
          << "sector " << c;
    }
    EXPECT_EQ(area_mm2(here), area_mm2(there));
    EXPECT_EQ(outline_loops(here), outline_loops(there));
  }
}

TEST(Region, IsMirroredWithItsPattern) {
  constexpr std::uint64_t seed = 9201;
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomPlane plane = random_plane(seed + i);
    Pattern mirrored = plane.pattern;
    double outlines = 0;
    for (Strand& strand : mirrored.strands) {
      std::reverse(strand.outline.begin(), strand.outline.end());
      for (PlanePoint& p : strand.outline) p.u = -p.u;
      for (std::size_t k = 0; k < strand.outline.size(); ++k) {
        const PlanePoint& next = strand.outline[(k + 1) % strand.outline.size()];
        outlines += std::hypot(next.u - strand.outline[k].u, next.z - strand.outline[k].z);
      }
    }
    const Region here = unite(plane.pattern, plane.grid, {}, 0.01);
    const Region there = unite(mirrored, plane.grid, {}, 0.01);
    const double step = std::max(plane.grid.u_step_mm, plane.grid.z_step_mm);
    EXPECT_NEAR(area_mm2(here), area_mm2(there), outlines * step);
    if (step < 1e-3) {  // on the coarse grid a window may well close on one side only
      EXPECT_EQ(outline_loops(here), outline_loops(there));
      EXPECT_EQ(pieces(triangulate(here)), pieces(triangulate(there)));
    }
  }
}

TEST(Region, OfRandomPatternsNeverTouchesItself) {
  constexpr std::uint64_t seed = 9401;
  for (std::uint64_t i = 0; i < 300; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const Region region = unite(plane.pattern, plane.grid, {}, 0.001);
    ASSERT_NO_FATAL_FAILURE(expect_two_edges_at_every_vertex(region));
  }
}

TEST(Region, GivesUpOnPointsThatCannotBeClosedInsteadOfReturningThem) {
  // Chequered squares far smaller than a diamond: whatever comes back must be clean.
  std::vector<StepOutline> squares;
  for (std::int32_t i = 0; i < 12; ++i) {
    for (std::int32_t k = i % 2; k < 12; k += 2) {
      squares.push_back(rectangle(500 + 3 * i, 500 + 3 * k, 3, 3));
    }
  }
  try {
    ASSERT_NO_FATAL_FAILURE(expect_two_edges_at_every_vertex(square_region(squares)));
  } catch (const GeometryError& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("touch"), std::string::npos);
  }
}

}  // namespace
}  // namespace latticast
