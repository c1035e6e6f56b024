// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that are cut so that they can be twisted and widened later, as a preview does.
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/tube_solids.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/mesh_measures.h"

namespace latticast {
namespace {

// Turned by `twist` per mm of height, widened by `growth`.
TriangleMesh deformed(const TriangleMesh& rest, double twist, double growth) {
  TriangleMesh mesh = rest;
  for (Point& p : mesh.vertices) {
    const double turn = twist * p[2];
    p = {growth * (p[0] * std::cos(turn) - p[1] * std::sin(turn)),
         growth * (p[0] * std::sin(turn) + p[1] * std::cos(turn)), p[2]};
  }
  return mesh;
}

// The largest distance of floor and ceiling from their cylinders, after deformation. Triangles are
// told apart at rest.
double cylinder_error(const TriangleMesh& rest, const TriangleMesh& mesh, double floor,
                      double ceiling, double growth) {
  double worst = 0;
  for (const Triangle& t : rest.triangles) {
    for (const double radius : {floor, ceiling}) {
      if (!lies_between(rest, t, 0.99 * radius, 1.01 * radius)) continue;
      for (const Point& p : points_over(mesh, t, 6)) {
        worst = std::max(worst, std::abs(radius_of(p) - growth * radius));
      }
    }
  }
  return worst;
}

struct Deformation {
  double twist;
  double growth;
};

constexpr Deformation deformations[] = {{0.04, 1}, {-0.04, 1}, {0.04, 1.4},
                                        {0.2, 1},  {0, 1.8},   {0.001, 1.1}};

SolidOptions options_for(const Deformation& deformation, double tolerance) {
  return {tolerance, 0, deformation.twist, deformation.growth};
}

TEST(TwistedSolid, StaysWithinTheToleranceOfItsCylinders) {
  for (const Deformation& deformation : deformations) {
    for (const double tolerance : {0.1, 0.01}) {
      SCOPED_TRACE(testing::Message() << "twist " << deformation.twist << ", growth "
                                      << deformation.growth << ", tolerance " << tolerance);
      const SolidOptions options = options_for(deformation, tolerance);
      for (const bool liner : {false, true}) {
        const Segment segment = example_segment();
        const Solid solid = liner ? liner_solid(segment, options) : lattice_solid(segment, options);
        const double floor = liner ? 12 : 16;
        const double ceiling = liner ? 16 : 18;
        const TriangleMesh mesh = deformed(solid.mesh, deformation.twist, deformation.growth);
        EXPECT_LE(cylinder_error(solid.mesh, mesh, floor, ceiling, deformation.growth), tolerance);
        EXPECT_EQ(genus(solid.mesh), solid.genus);
      }
    }
  }
}

TEST(TwistedSolid, NeedsItsCuts) {
  // Without them the same twist breaks the tolerance many times over: the test above can fail.
  const Deformation deformation{0.04, 1};
  const Solid uncut = lattice_solid(example_segment(90), {0.01, 0, 0, 1});
  const TriangleMesh mesh = deformed(uncut.mesh, deformation.twist, 1);
  EXPECT_GT(cylinder_error(uncut.mesh, mesh, 16, 18, 1), 0.1);
}

TEST(TwistedSolid, CutsDoNotChangeWhatIsMade) {
  const Solid plain = lattice_solid(example_segment(), {0.01, 0, 0, 1});
  const Solid cut = lattice_solid(example_segment(), {0.01, 0, 0.04, 1.3});
  EXPECT_EQ(cut.pieces, plain.pieces);
  EXPECT_EQ(cut.genus, plain.genus);
  EXPECT_NEAR(cut.volume_mm3, plain.volume_mm3, 1e-4 * plain.volume_mm3);
  EXPECT_GT(cut.mesh.triangles.size(), plain.mesh.triangles.size());
}

TEST(TwistedSolid, RefusesATwistBeyondReason) {
  EXPECT_THROW(lattice_solid(example_segment(), {0.01, 0, 1e4, 1}), GeometryError);
}

}  // namespace
}  // namespace latticast
