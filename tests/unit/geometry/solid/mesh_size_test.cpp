// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated sizes against meshes that were made.
#include "geometry/solid/mesh_size.h"

#include <gtest/gtest.h>

#include "design/read_design.h"

namespace latticast {
namespace {

std::vector<Segment> example_segments() {
  std::vector<Segment> segments;
  for (const char* file :
       {"twisting/twisting", "twisting/two_families", "bending/bending", "elongation/elongation",
        "superimposed/superimposed", "sinusoids/columns", "sinusoids/twisting"}) {
    const ReadResult read = read_design_file(
        std::string(LATTICAST_SOURCE_DIR) + "/examples/" + file + ".toml", built_in_materials());
    EXPECT_TRUE(read.ok()) << file;
    segments.push_back(read.design.segments.front());
  }
  return segments;
}

double made(const Segment& segment, const SolidOptions& options) {
  return static_cast<double>(lattice_solid(segment, options).mesh.triangles.size());
}

void expect_about(double estimate, double true_size, const std::string& what) {
  EXPECT_GE(estimate, true_size / 1.5) << what;
  EXPECT_LE(estimate, true_size * 1.5) << what;
}

TEST(MeshSize, OfALatticeIsAboutRight) {
  int number = 0;
  for (const Segment& segment : example_segments()) {
    const LatticeSize size(segment);
    for (const double tolerance : {0.05, 0.01}) {
      SolidOptions options;
      options.tolerance_mm = tolerance;
      const std::string what =
          "segment " + std::to_string(++number) + ", " + std::to_string(tolerance);
      expect_about(size.triangles(options), made(segment, options), what);
    }
  }
}

TEST(MeshSize, OfALatticeThatWillBeMovedIsAboutRight) {
  int number = 0;
  for (const Segment& segment : example_segments()) {
    SolidOptions options;
    options.tolerance_mm = 0.05;
    options.twist_rad_per_mm = 0.03;
    options.stretch_radius = 1.2;
    options.stretch = 1.4;
    expect_about(LatticeSize(segment).triangles(options), made(segment, options),
                 "segment " + std::to_string(++number));
  }
}

TEST(MeshSize, OfFillets) {
  Segment segment = example_segments().front();
  segment.lattice->fillet_mm = 0.8;
  for (const double tolerance : {0.02, 0.002}) {
    SolidOptions options;
    options.tolerance_mm = tolerance;
    expect_about(LatticeSize(segment).triangles(options), made(segment, options),
                 std::to_string(tolerance));
  }
}

TEST(MeshSize, OfALinerIsRight) {
  const Segment segment = example_segments().front();
  for (const double twist : {0.0, 0.02}) {
    SolidOptions options;
    options.twist_rad_per_mm = twist;
    const auto size = liner_solid(segment, options).mesh.triangles.size();
    expect_about(liner_triangles(segment, options), static_cast<double>(size), "");
  }
}

TEST(MeshSize, TheFittingToleranceJustFits) {
  const auto triangles = [](double tolerance_mm) { return 4.9e4 / tolerance_mm; };
  EXPECT_DOUBLE_EQ(fitting_tolerance_mm(triangles), 0.0037);
  EXPECT_DOUBLE_EQ(fitting_tolerance_mm([](double) { return 1e3; }), 1e-5);
}

}  // namespace
}  // namespace latticast
