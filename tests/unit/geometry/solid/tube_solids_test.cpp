// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/tube_solids.h"

#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh/weld.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/geometry_error.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/mesh_measures.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

SolidOptions with_tolerance(double tolerance_mm) {
  SolidOptions options;
  options.tolerance_mm = tolerance_mm;
  return options;
}

// Floor and ceiling triangles over all of their area.
void expect_near_cylinders(const TriangleMesh& mesh, double floor, double ceiling,
                           double tolerance) {
  int floors = 0;
  int ceilings = 0;
  const double middle = 0.5 * (floor + ceiling);
  for (const Triangle& t : mesh.triangles) {
    const bool below = lies_between(mesh, t, floor - 2 * tolerance, floor + 2 * tolerance);
    const bool above = lies_between(mesh, t, ceiling - 2 * tolerance, ceiling + 2 * tolerance);
    if (!below && !above) continue;
    ++(below ? floors : ceilings);
    for (const Point& p : points_over(mesh, t, 6)) {
      const double radius = radius_of(p);
      ASSERT_LE(std::abs(radius - (radius < middle ? floor : ceiling)), tolerance * (1 + 1e-9));
    }
  }
  EXPECT_GT(floors, 20);
  EXPECT_EQ(floors, ceilings);
}

void expect_as_promised(const Solid& solid, double relative) {
  ASSERT_TRUE(is_closed_and_oriented(solid.mesh));
  EXPECT_EQ(components(solid.mesh), solid.pieces);
  EXPECT_EQ(genus(solid.mesh), solid.genus);
  EXPECT_NEAR(volume_mm3(solid.mesh), solid.volume_mm3, relative * solid.volume_mm3);
  EXPECT_GT(solid.volume_bound_mm3, 0);
  const Audit result = audit(weld(solid.mesh));
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.components, solid.pieces);
  EXPECT_EQ(result.genus, solid.genus);
  EXPECT_NEAR(result.volume_mm3, solid.volume_mm3, solid.volume_bound_mm3);
}

TEST(LatticeSolid, OfTheExampleHasTheVolumeCountedByHand) {
  const Solid solid = lattice_solid(example_segment(), with_tolerance(0.01));
  ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
  EXPECT_NEAR(solid.volume_mm3, 7174.5268, 1e-5 * 7174.5268);
  EXPECT_EQ(solid.pieces, 1);
  // Eight rings with 8 x 7 windows between them, on a tube: 57 independent loops.
  EXPECT_EQ(solid.genus, 57);
}

TEST(LatticeSolid, StaysWithinTheToleranceOfItsCylinders) {
  for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
    SCOPED_TRACE(tolerance);
    const Solid solid = lattice_solid(example_segment(), with_tolerance(tolerance));
    ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
    if (tolerance < 1) expect_near_cylinders(solid.mesh, 16, 18, tolerance);
  }
}

TEST(LatticeSolid, OfRingsAloneIsOneTorusEach) {
  Segment segment = example_segment();
  segment.lattice->grids.clear();
  const Solid solid = lattice_solid(segment, with_tolerance(0.01));
  ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
  EXPECT_EQ(solid.pieces, 8);
  EXPECT_EQ(solid.genus, 8);
}

TEST(LatticeSolid, OfStripsAloneIsOneBallEach) {
  for (const double angle : {15.0, 36.0, 85.0, 90.0, 120.0}) {
    SCOPED_TRACE(angle);
    const Solid solid = lattice_solid(strips_only(angle, 16, 2), with_tolerance(0.01));
    ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
    EXPECT_EQ(solid.pieces, 3);
    EXPECT_EQ(solid.genus, 0);
  }
}

TEST(LinerSolid, IsASleeveOfGenusOne) {
  for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
    SCOPED_TRACE(tolerance);
    const Solid solid = liner_solid(example_segment(), with_tolerance(tolerance));
    ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
    EXPECT_EQ(solid.pieces, 1);
    EXPECT_EQ(solid.genus, 1);
    EXPECT_NEAR(solid.volume_mm3, std::numbers::pi * (16 * 16 - 12 * 12) * 85, 1e-7);
    if (tolerance < 1) expect_near_cylinders(solid.mesh, 12, 16, tolerance);
  }
}

TEST(LinerSolid, OfAThickWallStaysWithinItsCylinders) {
  Segment segment = example_segment();
  segment.liner = {0.5, 20, {}};
  const Solid solid = liner_solid(segment, with_tolerance(0.01));
  ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
  expect_near_cylinders(solid.mesh, 0.5, 20.5, 0.01);
}

TEST(TubeSolids, StartWhereTheSegmentStarts) {
  SolidOptions options = with_tolerance(0.05);
  options.start_z_mm = 123.5;
  const Audit result = audit(weld(lattice_solid(example_segment(), options).mesh));
  EXPECT_TRUE(result.passes());
  EXPECT_DOUBLE_EQ(result.lowest[2], 123.5);
  EXPECT_DOUBLE_EQ(result.highest[2], 208.5);
}

TEST(TubeSolids, FarAlongTheActuatorStillPassTheAudit) {
  // Float32 has steps of 4 micrometres there: grid points of the first segment would fall together.
  for (const double start : {500.0, 8000.0, 90000.0}) {
    SCOPED_TRACE(start);
    SolidOptions options = with_tolerance(0.05);
    options.start_z_mm = start;
    Segment segment = example_segment();
    segment.lattice->grids.push_back({36.01, std::vector<double>(8, 2.0), StraightPath{}});
    segment.lattice->grids.push_back({120, std::vector<double>(5, 1.0), StraightPath{}});
    ASSERT_NO_FATAL_FAILURE(expect_as_promised(lattice_solid(segment, options), 1e-11));
  }
}

TEST(TubeSolids, OfRandomSegmentsPassTheAudit) {
  constexpr std::uint64_t seed = 8001;
  int made = 0;
  for (std::uint64_t i = 0; i < 120; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Segment segment = random_segment(random);
    SolidOptions options = with_tolerance(random.log_between(0.005, 0.1));
    options.start_z_mm = random.between(0, 200);
    ASSERT_NO_FATAL_FAILURE(expect_as_promised(lattice_solid(segment, options), 1e-12));
    ++made;
  }
  EXPECT_EQ(made, 120);
}

TEST(TubeSolids, OfSliversStayWholeInFloat32) {
  const Solid solid = lattice_solid(narrow_windows(), with_tolerance(0.1091980024));
  ASSERT_NO_FATAL_FAILURE(expect_as_promised(solid, 1e-12));
}

TEST(TubeSolids, RefuseStrandsThatTheGridCannotHold) {
  // On 100 m of tube float32 tells 8 micrometres apart: strands of one micrometre would vanish.
  Segment segment = example_segment();
  segment.length_mm = 1e5;
  segment.lattice->rings = Rings{3, std::nullopt, 1e-3};
  segment.lattice->grids = {{90, std::vector<double>(3, 2.0), StraightPath{}}};
  try {
    lattice_solid(segment, with_tolerance(0.0005));
    FAIL() << "rings thinner than a grid step were made";
  } catch (const GeometryError& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("thin"), std::string::npos) << refusal.what();
  }
}

TEST(TubeSolids, RefuseMeshesBeyondAllMemory) {
  Segment segment = example_segment();
  segment.liner = {1, 1, {}};
  segment.lattice->thickness_mm = 200;
  segment.lattice->grids = {{45, std::vector<double>(5, 2.0), StraightPath{}}};
  EXPECT_THROW(lattice_solid(segment, with_tolerance(1e-5)), GeometryError);
}

}  // namespace
}  // namespace latticast
