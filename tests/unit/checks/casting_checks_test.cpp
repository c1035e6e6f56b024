// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/casting_checks.h"

#include <gtest/gtest.h>

#include "design/read_design.h"
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#include "molds/mold_options.h"
#include "molds/print_size.h"
#include "molds/replica_mold.h"
#include "tests/unit/checks/checked_designs.h"

namespace latticast {
namespace {

bool finds(const Design& design, std::string_view code) {
  return !with_code(findings_in_casting(design), code).empty();
}

CheckFinding only(const Design& design, std::string_view code) {
  const auto found = with_code(findings_in_casting(design), code);
  EXPECT_EQ(found.size(), 1U) << code;
  return found.empty() ? CheckFinding{} : found.front();
}

TEST(CastingChecks, LookAtNothingWithoutMolds) {
  EXPECT_TRUE(findings_in_casting(printed(twisting_segment())).empty());
}

TEST(LatticeMold, ExtentIsThatOfItsLargestPieces) {
  for (const double wall : {3.0, 5.0, 9.0}) {
    LatticeMoldOptions options;
    options.pieces = 3;
    options.fit.wall_mm = wall;
    options.fit.tolerance_mm = 0.05;
    const LatticeMoldPlan plan = plan_lattice_mold(twisting_segment(), options);
    PrintSize largest;
    for (const MoldPiece& piece : lattice_mold(plan).pieces) {
      const PrintSize size = print_size(piece);
      largest.width_mm = std::max({largest.width_mm, size.width_mm, size.depth_mm});
      largest.height_mm = std::max(largest.height_mm, size.height_mm);
    }
    EXPECT_NEAR(extent_of(plan).plate_diameter_mm, largest.width_mm, 0.15);
    EXPECT_NEAR(extent_of(plan).core_length_mm, largest.height_mm, 1e-4);
  }
}

void expect_extent(const MoldExtent& extent, const Mold& mold) {
  double widest = 0;
  double highest = 0;
  for (const MoldPiece& piece : mold.pieces) {
    const PrintSize size = print_size(piece);
    widest = std::max({widest, size.width_mm, size.depth_mm});
    highest = std::max(highest, size.height_mm);
  }
  EXPECT_NEAR(extent.plate_diameter_mm, widest, 0.15);
  EXPECT_NEAR(std::max({extent.core_length_mm, extent.plate_height_mm, extent.shell_height_mm}),
              highest, 1e-4);
}

TEST(ReplicaMold, ExtentIsThatOfItsLargestPieces) {
  const LatticeMoldPlan plan = plan_lattice_mold(twisting_segment(), {});
  expect_extent(replica_extent(plan), replica_mold(plan));
}

TEST(LinerMold, ExtentIsThatOfItsLargestPieces) {
  Segment thick = twisting_segment();
  thick.liner.thickness_mm = 9;  // its closed end is thicker than the floor under the core
  for (const LinerEnds ends : {LinerEnds::open, LinerEnds::closed, LinerEnds::flanged}) {
    LinerMoldOptions options;
    options.ends = ends;
    expect_extent(extent_of(thick, options), liner_mold(thick, options));
  }
}

// The design of a mold whose pieces took half a minute to mesh and fillet.
TEST(CastingChecks, MeshNoPieces) {
  const ReadResult read = read_design(R"(
name = "quick"
[[segment]]
length = 8.62846843
liner = { inner_radius = 12.8525202343, thickness = 4.68698803967, material = "dragon-skin-10" }
[segment.lattice]
thickness = 0.590798879735
material = { law = "linear", E = 1.74187501431 }
fillet = 0.593503467894
rings = { pitch = 1.62732289019, width = 0.811860196206 }
[[segment.lattice.grid]]
angle = 84.6305033501
count = 14
width = { from = 1.16752670347, to = 0.476420308759, profile = "cosine" }
[make]
lattice_mold = { method = "replica", pieces = 3, wall = 2.10821636063 }
[export]
tolerance = 0.000375951669661
)",
                                      built_in_materials());
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(findings_in_casting(read.design).empty());
}

// The cylinder inside the shell less the core and the cavity, all but the seams.
TEST(BesideCavity, IsFilmAndBores) {
  Segment rings = twisting_segment();
  rings.lattice->grids.clear();
  const LatticeMoldPlan plan = plan_lattice_mold(rings, {});
  double bores = 0;
  for (const Bore& bore : plan.shell.bores) bores += test_pi * bore.radius_mm * bore.radius_mm * 5;
  const double free_length = 85 + 2 * 5 - 8 * 2;
  EXPECT_NEAR(beside_cavity_mm3(plan), 2 * test_pi * 16 * free_length * 0.15 + bores, 0.05);
}

TEST(MoldWall, LetsPassWhatIsAtItsLimit) {
  Design design = printed(twisting_segment());
  design.make.liner_mold.emplace();
  for (const auto& [wall, left] : {std::pair{1.5, 1.0}, std::pair{4.5, 3.0}, std::pair{6.0, 4.5}}) {
    design.make.liner_mold->wall_mm = wall;
    design.printer.min_wall_mm = left;
    EXPECT_FALSE(finds(design, "mold-wall-too-thin")) << wall;
    design.printer.min_wall_mm = left * 1.001;
    const CheckFinding thin = only(design, "mold-wall-too-thin");
    EXPECT_NEAR(*thin.value, left, 1e-12);
    design.make.liner_mold->wall_mm = remedy_value(thin, "liner_mold.wall").value();
    EXPECT_FALSE(finds(design, "mold-wall-too-thin")) << thin.remedy;
  }
}

TEST(DemoldingStrain, AsksForAsManyPiecesAsAreGentle) {
  Design design = cast(twisting_segment());
  design.make.lattice_mold->pieces = 3;
  const CheckFinding hard = only(design, "demolding-strain");
  EXPECT_EQ(hard.severity, Severity::warning);
  EXPECT_EQ(*hard.limit, 0.5);
  design.make.lattice_mold->pieces =
      static_cast<int>(remedy_value(hard, "lattice_mold.pieces").value());
  EXPECT_FALSE(finds(design, "demolding-strain"));
}

TEST(DemoldingStrain, BeyondBreakIsAnError) {
  Design design = cast(twisting_segment());
  design.make.lattice_mold->pieces = 2;
  design.segments[0].lattice->material.elongation_at_break = 0.5;
  EXPECT_EQ(only(design, "demolding-strain").severity, Severity::error);
  design.segments[0].lattice->material.elongation_at_break = 20;
  EXPECT_FALSE(finds(design, "demolding-strain"));
}

TEST(MoldImpossible, IsAFindingWithTheReason) {
  Design design = cast(twisting_segment());
  design.make.lattice_mold->pieces = 90;
  EXPECT_NE(only(design, "mold-impossible").message.find("fewer"), std::string::npos);
  design = cast(twisting_segment());
  design.segments[0].lattice->thickness_mm = 0.1;
  EXPECT_NE(only(design, "mold-impossible").message.find("thicker lattice"), std::string::npos);
  design = printed(twisting_segment());
  design.make.liner_mold.emplace();
  design.make.liner_mold->pieces = 100;
  design.segments[0].liner = {2, 1, {}};
  EXPECT_EQ(only(design, "mold-impossible").part, "liner-mold");
}

TEST(ExceedsBed, NamesPiecesOfMolds) {
  Design design = cast(twisting_segment());
  design.make.liner_mold.emplace();
  design.printer.bed_mm = {60, 60, 104};
  const auto found = with_code(findings_in_casting(design), "exceeds-bed");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].part, "lattice-mold core");
  EXPECT_NEAR(*found[0].value, 85 + 2 * 10 - 0.3, 1e-9);
  design.printer.bed_mm = {50, 50, 200};
  std::vector<std::string> parts;
  for (const CheckFinding& f : with_code(findings_in_casting(design), "exceeds-bed")) {
    parts.push_back(f.part);
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"lattice-mold base", "liner-mold base"}));
}

TEST(CastingChecks, ReplicaMoldsHaveNoGrooves) {
  Design design = cast(twisting_segment());
  design.make.lattice_mold->method = MoldMethod::replica;
  design.make.lattice_mold->pieces = 2;
  EXPECT_TRUE(findings_in_casting(design).empty());
  design.printer.bed_mm = {40, 40, 300};
  EXPECT_TRUE(finds(design, "exceeds-bed"));
}

TEST(CastingChecks, NeverThrow) {
  const unsigned seed = 20266;
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", design " + std::to_string(i));
    Segment segment = twisting_segment();
    segment.length_mm = uniform(5, 60);
    segment.liner = {uniform(2, 20), uniform(0.5, 5), {}};
    Lattice& lattice = *segment.lattice;
    lattice.thickness_mm = uniform(0.1, 3);
    lattice.rings = Rings{2, std::nullopt, uniform(0.1, 2)};
    lattice.grids[0].angle_deg = uniform(10, 170);
    lattice.grids[0].widths_mm.assign(3, uniform(0.05, 0.8));
    if (i % 5 == 0) lattice.grids[0].path = Horseshoe{uniform(0.5, 3), 180, i % 2 == 0};
    Design design = cast(segment);
    design.output.tolerance_mm = 0.05;
    design.make.lattice_mold->wall_mm = uniform(3.1, 6);
    if (i % 3 == 0) design.make.lattice_mold->pieces = 2 + i;
    design.make.liner_mold.emplace();
    design.make.liner_mold->keyed = i % 4 == 0;
    EXPECT_NO_THROW(findings_in_casting(design));
  }
}

}  // namespace
}  // namespace latticast
