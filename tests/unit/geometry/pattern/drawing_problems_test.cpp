// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be drawn is named, and what the message proposes can be drawn.
#include "geometry/pattern/drawing_problems.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/pattern/cannot_draw.h"
#include "geometry/pattern/horseshoe_path.h"
#include "geometry/pattern/pattern.h"

namespace latticast {
namespace {

// Liner 12 to 16, layer 16 to 18, 85 long; 16 half circles of R = 85/32 fill it.
Segment segment_with(const Horseshoe& shape, std::vector<double> widths, double angle = 90) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, Rings{8, std::nullopt, 2}, {}};
  segment.lattice->grids = {{angle, std::move(widths), shape}};
  return segment;
}

// The number that follows `word` in `text`.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) {
    ADD_FAILURE() << "no '" << word << "' in: " << text;
    return 0;
  }
  return std::stod(text.substr(at + word.size()));
}

std::string only_problem(const Segment& segment) {
  const std::vector<std::string> problems = drawing_problems(segment);
  std::string all;
  for (const std::string& problem : problems) all += problem + "\n";
  EXPECT_EQ(problems.size(), 1U) << all;
  return all;
}

constexpr Horseshoe closing{85.0 / 32, 180, true};

TEST(DrawingProblems, AreNoneForWhatCanBeDrawn) {
  EXPECT_TRUE(drawing_problems(segment_with(closing, std::vector<double>(8, 1.0))).empty());
  // To three decimals, as a person writes it.
  EXPECT_TRUE(drawing_problems(segment_with({2.656, 180, true}, {1, 2, 1, 2})).empty());
  Segment straight = segment_with(closing, {1});
  straight.lattice->grids[0].path = StraightPath{};
  EXPECT_TRUE(drawing_problems(straight).empty());
  straight.lattice.reset();
  EXPECT_TRUE(drawing_problems(straight).empty());
}

TEST(DrawingProblems, RadiusThatDoesNotCloseIsNamedOnceWithTheNearestThatDoes) {
  Segment segment = segment_with({2.7, 180, true}, {0.5, 0.6, 0.7, 0.8});
  const std::string problem = only_problem(segment);
  EXPECT_NE(problem.find("lattice.grid[0].horseshoe: 15.74 arcs"), std::string::npos) << problem;
  EXPECT_NEAR(number_after(problem, "whole number; radius "), 85.0 / 32, 1e-5);
  std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm =
      number_after(problem, "whole number; radius ");
  EXPECT_TRUE(drawing_problems(segment).empty());
}

TEST(DrawingProblems, StrandsThatFoldOverThemselvesGetARadius) {
  Segment segment = segment_with({85.0 / 320, 180, true}, {0.4, 0.6, 0.4});
  const std::string problem = only_problem(segment);
  EXPECT_NE(problem.find("strand 2 of 3 (at 120.0 degrees"), std::string::npos) << problem;
  std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm =
      number_after(problem, "themselves: radius ");
  EXPECT_TRUE(drawing_problems(segment).empty());
  segment.lattice->grids[0].widths_mm = {20};
  segment.lattice->grids[0].path = Horseshoe{5, 180, true};
  segment.length_mm = 10;
  EXPECT_NEAR(number_after(only_problem(segment), "width below "), 10, 1e-9);
}

TEST(DrawingProblems, ArcsThatRunIntoTheNextGetASmallerArc) {
  for (const bool alternate : {true, false}) {
    const Horseshoe wide{85.0 / 32 / std::sin(135 * std::numbers::pi / 180), 270, alternate};
    Segment segment = segment_with(wide, {3.5, 3.5});
    const std::string problem = only_problem(segment);
    EXPECT_NE(problem.find("270 degrees"), std::string::npos) << problem;
    Horseshoe& shape = std::get<Horseshoe>(segment.lattice->grids[0].path);
    shape.arc_deg = number_after(problem, "; arc ");
    shape.radius_mm = number_after(problem, "with radius ");
    ASSERT_GT(shape.radius_mm, 1);
    EXPECT_GE(shape.arc_deg, 180);
    EXPECT_TRUE(drawing_problems(segment).empty());
    shape.arc_deg += 0.2;
    shape.radius_mm = 85.0 / 32 / std::sin(0.5 * shape.arc_deg * std::numbers::pi / 180);
    EXPECT_FALSE(drawing_problems(segment).empty()) << "the arc proposed is not the largest";
  }
}

TEST(DrawingProblems, NeighboursThatOverlapGetACountAndAWidth) {
  // Half circles in phase, 2 pi 17/16 = 6.68 apart; circles of R 10.6 leave less between them.
  const double radius = 85.0 / 8;
  Segment segment = segment_with({radius, 180, true}, std::vector<double>(16, 2.5));
  EXPECT_TRUE(drawing_problems(segment).empty()) << "it is drawn as one net";
  const std::vector<std::string> overlaps = overlapping_neighbours(segment);
  ASSERT_EQ(overlaps.size(), 1U);
  const std::string& problem = overlaps.front();
  EXPECT_NE(problem.find("strand 1 of 16 (at 0.0 degrees around the tube): overlaps strand 2"),
            std::string::npos)
      << problem;
  Grid& grid = segment.lattice->grids[0];
  const int count = static_cast<int>(number_after(problem, "; count "));
  grid.widths_mm.assign(count, 2.5);
  EXPECT_TRUE(overlapping_neighbours(segment).empty());
  grid.widths_mm.assign(count + 1, 2.5);
  EXPECT_FALSE(overlapping_neighbours(segment).empty()) << "one more would have fitted";
  grid.widths_mm.assign(16, 0.999 * number_after(problem, "widths below "));
  EXPECT_TRUE(overlapping_neighbours(segment).empty());
}

TEST(DrawingProblems, WiderStrandsAreBlamedWhereTheyAre) {
  const double radius = 85.0 / 8;
  std::vector<double> widths(12, 0.5);
  widths[5] = 7;
  const std::vector<std::string> problems =
      overlapping_neighbours(segment_with({radius, 180, true}, widths));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("strand 5 of 12 (at 120.0 degrees"), std::string::npos) << problems[0];
}

TEST(DrawingProblems, StrandsPartedByTheCutGetMoreArcs) {
  const double radius = 85 / std::sin(std::numbers::pi / 18) / 8;
  Segment segment = segment_with({radius, 180, true}, {1}, 10);
  segment.liner.inner_radius_mm = 1000;
  const std::string problem = only_problem(segment);
  std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm =
      number_after(problem, "it; radius ");
  EXPECT_TRUE(drawing_problems(segment).empty());
}

TEST(DrawingProblems, OfAllFamiliesAndSegmentsAreThrownTogether) {
  Segment first = segment_with({2.7, 180, true}, {1});
  first.lattice->grids.push_back({60, {1}, Horseshoe{3, 200, false}});
  const Segment good = segment_with(closing, {1});
  const Segment last = segment_with({2.6, 90, true}, {1});
  try {
    require_drawable(std::vector<Segment>{first, good, last});
    FAIL() << "nothing was said";
  } catch (const CannotDraw& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("segment[0].lattice.grid[0]"), std::string::npos) << text;
    EXPECT_NE(text.find("segment[0].lattice.grid[1]"), std::string::npos) << text;
    EXPECT_EQ(text.find("segment[1]"), std::string::npos) << text;
    EXPECT_NE(text.find("segment[2].lattice.grid[0]"), std::string::npos) << text;
  }
  EXPECT_NO_THROW(require_drawable(std::vector<Segment>{good}));
  EXPECT_THROW(draw_lattice(last, 0.005), CannotDraw);
}

}  // namespace
}  // namespace latticast
