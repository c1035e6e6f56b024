// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/replica_mold.h"

#include <algorithm>

#include "design/units.h"
#include "tests/unit/molds/lattice_molds.h"
#include "tests/unit/molds/sound_solid.h"

namespace latticast {
namespace {

Segment paper_segment(const Grid& grid) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  segment.lattice.emplace();
  segment.lattice->thickness_mm = 2;
  segment.lattice->rings = Rings{8, std::nullopt, 2};
  segment.lattice->grids = {grid};
  return segment;
}

const MoldPiece& piece_named(const Mold& mold, const std::string& name) {
  return *std::find_if(mold.pieces.begin(), mold.pieces.end(),
                       [&](const MoldPiece& piece) { return piece.name == name; });
}

void expect_replica(const Segment& segment) {
  const Mold mold = replica_mold(segment, {});
  for (const char* name : {"pattern", "core", "base", "shell-1", "shell-2", "cap"}) {
    SCOPED_TRACE(name);
    const Solid& solid = piece_named(mold, name).solid;
    expect_sound(solid, solid.genus);
  }
  const Solid& pattern = piece_named(mold, "pattern").solid;
  const Solid& core = piece_named(mold, "core").solid;
  // A rod with the lattice on it has the handles of the lattice's pattern less the ring's own: it
  // has none, since everything stands on the rod.
  EXPECT_EQ(pattern.genus, 0);
  // The lattice is there in full: what the pattern has more than the core is lattice and gates.
  const Solid cast = lattice_solid(segment, {});
  const double more = pattern.volume_mm3 - core.volume_mm3;
  EXPECT_GT(more, cast.volume_mm3);
  EXPECT_LT(more, cast.volume_mm3 + 8 * 8 * 2 * pi * 2 * 2);
  // And the flexible mold fills what is left between core and box.
  const double length = 85 + 2 * 5;
  const double annulus = pi * (26.0 * 26.0 - 16.0 * 16.0) * length;
  EXPECT_NEAR(mold.cavity_mm3 + more, annulus, 1e-4 * annulus);
  for (const Point& p : pattern.mesh.vertices) EXPECT_LT(std::hypot(p[0], p[1]), 26);
}

TEST(ReplicaMold, OfStrips) {
  expect_replica(paper_segment({36, std::vector<double>(8, 2.0), StraightPath{}}));
}

TEST(ReplicaMold, OfHorseshoes) {
  expect_replica(
      paper_segment({90, std::vector<double>(16, 2.0), Horseshoe{85.0 / 32, 180, true}}));
}

// Levels of steep walls are closer together than the chamfer is deep.
TEST(ReplicaMold, IsSoundAtFineTolerances) {
  const Segment segment = paper_segment({36, std::vector<double>(8, 2.0), StraightPath{}});
  for (const double tolerance : {0.5, 0.003, 0.002, 0.0005}) {
    SCOPED_TRACE(tolerance);
    LatticeMoldOptions options;
    options.fit.tolerance_mm = tolerance;
    const Mold mold = replica_mold(segment, options);
    const Solid& pattern = piece_named(mold, "pattern").solid;
    expect_sound(pattern, 0);
    EXPECT_LT(pattern.error.surface_mm, 2 * std::min(tolerance, 0.06));
  }
}

TEST(ReplicaMold, RefusesWhatADirectMoldRefuses) {
  const Segment segment = paper_segment({36, std::vector<double>(8, 2.0), StraightPath{}});
  LatticeMoldOptions options;
  options.fit.wall_mm = 0.1;
  EXPECT_THROW(replica_mold(segment, options), CannotMold);
}

}  // namespace
}  // namespace latticast
