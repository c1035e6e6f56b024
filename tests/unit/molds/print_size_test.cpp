// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/print_size.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "molds/liner_mold.h"
#include "tests/unit/molds/sound_solid.h"

namespace latticast {
namespace {

// Only its corners count: a box of the given sides, turned around the axis.
MoldPiece box(double width, double depth, double height, double turn_rad) {
  MoldPiece piece;
  piece.name = "shell-1";
  piece.pulls_sideways = true;
  piece.pull_rad = turn_rad;
  for (const double x : {5.0, 5 + width}) {
    for (const double y : {-0.5 * depth, 0.5 * depth}) {
      for (const double z : {-3.0, height - 3}) {
        piece.solid.mesh.vertices.push_back({x * std::cos(turn_rad) - y * std::sin(turn_rad),
                                             x * std::sin(turn_rad) + y * std::cos(turn_rad), z});
      }
    }
  }
  return piece;
}

TEST(PrintSize, IsThatOfThePieceTurnedToItsPull) {
  for (const double turn : {0.0, 0.7, 2.0, 5.5}) {
    const PrintSize size = print_size(box(20, 40, 85, turn));
    EXPECT_NEAR(size.width_mm, 20, 1e-9);
    EXPECT_NEAR(size.depth_mm, 40, 1e-9);
    EXPECT_NEAR(size.height_mm, 85, 1e-9);
  }
  MoldPiece core = box(20, 40, 85, std::numbers::pi / 2);
  core.pulls_sideways = false;
  EXPECT_NEAR(print_size(core).width_mm, 40, 1e-9);
}

TEST(PrintingPose, StandsOnTheBedAndTurnsTheCapOver) {
  for (const char* name : {"shell-1", "cap"}) {
    MoldPiece piece = box(20, 40, 85, 0.7);
    piece.name = name;
    // A spike that only the lower end has.
    piece.solid.mesh.vertices.push_back({5, 0, -4});
    const TriangleMesh posed = printing_pose(piece);
    double lowest = 1;
    for (const Point& p : posed.vertices) lowest = std::min(lowest, p[2]);
    EXPECT_EQ(lowest, 0);
    EXPECT_NEAR(posed.vertices.back()[2], piece.name == "cap" ? 86 : 0, 1e-9);
  }
}

TEST(PrintingPose, KeepsACapSound) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  MoldPiece cap = liner_mold(segment, {}).pieces.back();
  ASSERT_EQ(cap.name, "cap");
  cap.solid.mesh = printing_pose(cap);
  expect_sound(cap.solid, 3);
  // The rim, 6 mm high, stands up now; the plate with its socket is 9 mm thick.
  for (const Point& p : cap.solid.mesh.vertices) {
    if (p[2] > 9.001) {
      EXPECT_GT(std::hypot(p[0], p[1]), 21);
    }
  }
}

TEST(BedProblem, NamesWhatDoesNotFit) {
  const MoldPiece piece = box(20, 40, 85, 0.7);
  EXPECT_EQ(bed_problem(piece, {20.001, 40.001, 85.001}), "");
  EXPECT_EQ(bed_problem(piece, {40.001, 20.001, 85.001}), "");
  const std::string wide = bed_problem(piece, {30, 30, 100});
  EXPECT_NE(wide.find("shell-1 is 20 x 40 x 85 mm"), std::string::npos) << wide;
  EXPECT_NE(wide.find("30 x 30 x 100 mm: use more pieces"), std::string::npos) << wide;
  EXPECT_EQ(wide.find("divide"), std::string::npos) << wide;
  const std::string high = bed_problem(piece, {50, 50, 80});
  EXPECT_NE(high.find(": divide the segment"), std::string::npos) << high;
  EXPECT_EQ(high.find("pieces,"), std::string::npos) << high;
  const std::string both = bed_problem(piece, {10, 50, 80});
  EXPECT_NE(both.find("more pieces"), std::string::npos) << both;
  EXPECT_NE(both.find("divide"), std::string::npos) << both;
}

}  // namespace
}  // namespace latticast
