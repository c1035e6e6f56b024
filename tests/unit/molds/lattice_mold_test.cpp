// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/lattice_mold.h"

#include <algorithm>

#include "design/units.h"
#include "geometry/solid/layered_solid.h"
#include "geometry/solid/region.h"
#include "geometry/solid/relief.h"
#include "tests/unit/molds/lattice_molds.h"

namespace latticast {
namespace {

struct NamedSegment {
  std::string name;
  Segment segment;
};

std::vector<NamedSegment> segments() {
  Segment one_ring = column_segment(4);
  one_ring.lattice->rings = Rings{std::nullopt, 60.0, 3};
  Segment rings_only = ringed_segment();
  Segment wide = twisting_segment();
  wide.lattice->grids[0].widths_mm.assign(5, 7.0);
  Segment filleted = twisting_segment();
  filleted.lattice->fillet_mm = 0.8;
  Segment strips_only = twisting_segment();
  strips_only.lattice->rings.reset();
  Segment crossed = twisting_segment();
  crossed.lattice->grids.push_back({144, std::vector<double>(8, 2.0), StraightPath{}});
  return {{"twisting", twisting_segment()},
          {"bending", bending_segment()},
          {"superimposed", superimposed_segment()},
          {"columns", column_segment()},
          {"one ring", one_ring},
          {"rings only", rings_only},
          {"wide strands", wide},
          {"filleted", filleted},
          {"strips without rings", strips_only},
          {"crossed families", crossed}};
}

TEST(LatticeMold, IsSoundAndDisjointForEveryKindOfLattice) {
  for (const NamedSegment& named : segments()) {
    SCOPED_TRACE(named.name);
    const LatticeMoldPlan plan = plan_lattice_mold(named.segment, {});
    const Mold mold = lattice_mold(plan);
    EXPECT_EQ(mold.pieces.size(), plan.shell.parting.pieces + 3U);
    expect_sound_mold(mold);
  }
}

TEST(LatticeMold, IsSoundInAnyNumberOfPieces) {
  for (int pieces = 2; pieces <= 8; ++pieces) {
    SCOPED_TRACE(pieces);
    LatticeMoldOptions options;
    options.pieces = pieces;
    const Mold mold = lattice_mold(twisting_segment(), options);
    EXPECT_EQ(mold.pieces.size(), pieces + 3U);
    expect_sound_mold(mold);
  }
}

// The united area of some drawn things at R_c.
double area_of(const Shell& shell, std::vector<Strand> strands) {
  const Pattern drawn{shell.lattice.circumference_mm, shell.lattice.length_mm, std::move(strands)};
  const PlaneGrid grid = make_plane_grid(drawn.circumference_mm, drawn.length_mm,
                                         sectors_for(shell.outer_radius_mm, 0.01));
  return area_mm2(unite(drawn, grid, {}, 0.01));
}

// What is left free between two neighbouring pieces.
Strand gap_at(const Shell& shell, int seam) {
  const double middle = shell.parting.drawn_radius_mm * seam_rad(shell.parting, seam);
  const double half = 0.5 * shell.clearance_mm;
  Strand gap;
  std::vector<PlanePoint> left;
  for (const PlanePoint& p : shell.parting.seam) {
    gap.outline.push_back({middle + half + p.u, p.z});
    left.push_back({middle - half + p.u, p.z});
  }
  gap.outline.insert(gap.outline.end(), left.rbegin(), left.rend());
  return gap;
}

TEST(LatticeMold, ShellAndGapsFillTheAnnulus) {
  for (const Segment& segment : {twisting_segment(), superimposed_segment()}) {
    const LatticeMoldPlan plan = plan_lattice_mold(segment, {});
    const Mold mold = lattice_mold(plan);
    const Shell& shell = plan.shell;
    std::vector<Strand> cut;
    cut.reserve(shell.parting.pieces);
    for (int k = 0; k < shell.parting.pieces; ++k) cut.push_back(gap_at(shell, k));
    const double drawn = shell.parting.drawn_radius_mm;
    for (const Bore& b : shell.bores) {
      cut.push_back(drawn_disc(drawn, b.middle.u / drawn, b.middle.z, b.radius_mm, 0.005));
    }
    std::vector<Strand> cut_in_lands = cut;
    cut_in_lands.insert(cut_in_lands.end(), shell.lattice.strands.begin(),
                        shell.lattice.strands.end());
    std::vector<Strand> cut_outside = cut;
    for (const StrapGroove& strap : shell.straps) {
      cut_outside.push_back(drawn_band(drawn, strap.from_mm, strap.to_mm));
    }
    const double plane = shell.lattice.circumference_mm * shell.lattice.length_mm;
    const auto volume = [&](double area, double from, double to) {
      return (plane - area) * (to * to - from * from) / (2 * drawn);
    };
    const double core = shell.cast.floor_mm + 0.5 * shell.clearance_mm;
    const double expected =
        volume(area_of(shell, cut_in_lands), core, shell.cast.ceiling_mm) +
        volume(area_of(shell, cut), shell.cast.ceiling_mm, shell.strap_radius_mm) +
        volume(area_of(shell, cut_outside), shell.strap_radius_mm, shell.outer_radius_mm);
    double made = 0;
    for (int k = 0; k < shell.parting.pieces; ++k) {
      made += audit(weld(mold.pieces[k].solid.mesh)).volume_mm3;
    }
    EXPECT_NEAR(made, expected, 1e-5 * expected);
  }
}

TEST(LatticeMold, CavityIsTheLattice) {
  for (const NamedSegment& named : segments()) {
    SCOPED_TRACE(named.name);
    const Mold mold = lattice_mold(named.segment, {});
    const double lattice = lattice_solid(named.segment, {}).volume_mm3;
    EXPECT_NEAR(mold.cavity_mm3, lattice, 1e-4 * lattice);
  }
}

TEST(LatticeMold, GrowsAgainstShrinkage) {
  LatticeMoldOptions options;
  options.fit.growth = 1.02;
  const Mold mold = lattice_mold(twisting_segment(), options);
  const double lattice = lattice_solid(twisting_segment(), {}).volume_mm3;
  EXPECT_NEAR(mold.cavity_mm3, std::pow(1.02, 3) * lattice, 1e-4 * lattice);
  const auto core = std::find_if(mold.pieces.begin(), mold.pieces.end(),
                                 [](const MoldPiece& p) { return p.name == "core"; });
  ASSERT_NE(core, mold.pieces.end());
  double radius = 0;
  for (const Point& p : core->solid.mesh.vertices) {
    radius = std::max(radius, std::hypot(p[0], p[1]));
  }
  EXPECT_NEAR(radius, 16 * 1.02, 0.011);
}

// Where the shell is thinnest around the cavity, and where pieces end.
TEST(LatticeMold, PiecesKeepTheirRadii) {
  const LatticeMoldPlan plan = plan_lattice_mold(twisting_segment(), {});
  const Mold mold = lattice_mold(plan);
  for (int k = 0; k < plan.shell.parting.pieces; ++k) {
    for (const Point& p : mold.pieces[k].solid.mesh.vertices) {
      const double r = std::hypot(p[0], p[1]);
      EXPECT_GE(r, 16.15 - 0.011);
      EXPECT_LE(r, 23.011);
      EXPECT_GE(p[2], -5 - 1e-9);
      EXPECT_LE(p[2], 90 + 1e-9);
    }
    EXPECT_TRUE(mold.pieces[k].pulls_sideways);
    EXPECT_LE(std::abs(mold.pieces[k].pull_rad), pi);
  }
}

TEST(LatticeMold, BoresAndStrapsKeepOffTheRims) {
  for (const NamedSegment& named : segments()) {
    SCOPED_TRACE(named.name);
    const LatticeMoldPlan plan = plan_lattice_mold(named.segment, {});
    const double length = plan.shell.lattice.length_mm;
    const double rim = plan.land_mm - 1;
    for (const Bore& bore : plan.shell.bores) {
      EXPECT_GT(bore.middle.z - bore.radius_mm, rim);
      EXPECT_LT(bore.middle.z + bore.radius_mm, length - rim);
    }
    ASSERT_EQ(plan.shell.straps.size(), 2U);
    EXPECT_GT(plan.shell.straps[0].from_mm, rim);
    EXPECT_LT(plan.shell.straps[0].to_mm, plan.shell.straps[1].from_mm);
    EXPECT_LT(plan.shell.straps[1].to_mm, length - rim);
  }
  const LatticeMoldPlan twisting = plan_lattice_mold(twisting_segment(), {});
  for (const StrapGroove& strap : twisting.shell.straps) {
    for (const Bore& bore : twisting.shell.bores) {
      EXPECT_TRUE(bore.middle.z + bore.radius_mm < strap.from_mm ||
                  bore.middle.z - bore.radius_mm > strap.to_mm);
    }
  }
}

TEST(LatticeMold, RefusesWhatCannotBeMade) {
  const Segment segment = twisting_segment();
  LatticeMoldOptions options;
  options.fit.wall_mm = 0;
  EXPECT_THROW(lattice_mold(segment, options), CannotMold);
  options.fit.wall_mm = 0.2;
  EXPECT_THROW(lattice_mold(segment, options), CannotMold);
  options = {};
  options.fit.clearance_mm = 4.5;
  EXPECT_THROW(lattice_mold(segment, options), CannotMold);
  options.fit.clearance_mm = 0;
  EXPECT_THROW(lattice_mold(segment, options), CannotMold);
  options = {};
  options.pieces = 60;
  EXPECT_THROW(lattice_mold(segment, options), CannotMold);
}

TEST(LatticeMold, SaysHowMuchItCatches) {
  LatticeMoldOptions options;
  options.pieces = 2;
  const Mold halves = lattice_mold(twisting_segment(), options);
  ASSERT_GE(halves.notes.size(), 3U);
  EXPECT_NE(halves.notes[0].find("shell-"), std::string::npos);
  EXPECT_EQ(halves.notes[1].find("Undercuts: shell-1 "), 0U) << halves.notes[1];
  EXPECT_NE(halves.notes[1].find(", shell-2 "), std::string::npos);
  EXPECT_NE(halves.notes[2].find("more shell pieces"), std::string::npos);
}

}  // namespace
}  // namespace latticast
