// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_design.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "design/file_error.h"
#include "tests/unit/design/example_design.h"

namespace latticast {
namespace {

Design read_valid(std::string_view text) {
  ReadResult result = read_design(text, built_in_materials());
  for (const Issue& issue : result.issues) ADD_FAILURE() << describe(issue, "design");
  return result.design;
}

TEST(ReadDesign, FirstSegmentOfTheWholeGrammar) {
  const Design design = read_valid(whole_grammar);
  EXPECT_EQ(design.name, "two-segments");
  ASSERT_EQ(design.segments.size(), 3U);
  const Segment& first = design.segments[0];
  EXPECT_EQ(first.length_mm, 85);
  EXPECT_EQ(first.liner.inner_radius_mm, 12);
  EXPECT_EQ(first.liner.thickness_mm, 4);
  EXPECT_EQ(first.liner.material.name, "ecoflex-00-50");
  EXPECT_EQ(std::get<NeoHookean>(first.liner.material.law).shear_modulus_mpa, 0.08);
  ASSERT_TRUE(first.lattice);
  EXPECT_EQ(first.lattice->thickness_mm, 2);
  EXPECT_EQ(std::get<Linear>(first.lattice->material.law).youngs_modulus_mpa, 19.46);
  EXPECT_EQ(first.lattice->fillet_mm, 0.5);
  ASSERT_TRUE(first.lattice->rings);
  EXPECT_EQ(first.lattice->rings->count, 8);
  EXPECT_FALSE(first.lattice->rings->pitch_mm);
  EXPECT_EQ(first.lattice->rings->width_mm, 2.5);
  ASSERT_EQ(first.lattice->grids.size(), 2U);
  EXPECT_EQ(first.lattice->grids[0].angle_deg, 36);
  EXPECT_EQ(first.lattice->grids[0].widths_mm, std::vector<double>(8, 2.0));
  EXPECT_FALSE(is_curved(first.lattice->grids[0].path));
  EXPECT_EQ(first.lattice->grids[1].angle_deg, 120.5);
  EXPECT_EQ(first.lattice->grids[1].widths_mm, (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(first.lattice_mid_radius_mm(), 17);
}

TEST(ReadDesign, SecondAndThirdSegmentOfTheWholeGrammar) {
  const Design design = read_valid(whole_grammar);
  ASSERT_EQ(design.segments.size(), 3U);
  const Segment& second = design.segments[1];
  EXPECT_EQ(second.liner.material.name, "inline");
  const auto& yeoh = std::get<Yeoh>(second.liner.material.law);
  EXPECT_EQ(yeoh.c1_mpa, 0.02);
  EXPECT_EQ(yeoh.c2_mpa, -0.001);
  EXPECT_EQ(yeoh.c3_mpa, 0.0001);
  ASSERT_TRUE(second.lattice);
  EXPECT_EQ(second.lattice->fillet_mm, 0);
  EXPECT_EQ(std::get<Linear>(second.lattice->material.law).youngs_modulus_mpa, 30);
  EXPECT_EQ(std::get<Linear>(second.lattice->material.law).poisson_ratio, 0.4);
  EXPECT_EQ(second.lattice->rings->pitch_mm, 10);
  EXPECT_EQ(second.lattice->rings->phase, 0.25);
  EXPECT_FALSE(second.lattice->rings->count);
  ASSERT_EQ(second.lattice->grids.size(), 2U);
  const auto& stated = std::get<Horseshoe>(second.lattice->grids[0].path);
  EXPECT_EQ(stated.radius_mm, 2.656);
  EXPECT_EQ(stated.arc_deg, 170);
  EXPECT_FALSE(stated.alternate);
  const auto& short_form = std::get<Horseshoe>(second.lattice->grids[1].path);
  EXPECT_EQ(short_form.arc_deg, 180);
  EXPECT_TRUE(short_form.alternate);
  EXPECT_FALSE(design.segments[2].lattice);
  EXPECT_EQ(std::get<Gent>(design.segments[2].liner.material.law).limit_jm, 40);
  EXPECT_EQ(design.segments[2].liner.material.shrinkage, 0.004);
}

TEST(ReadDesign, GradedWidths) {
  const Design design = read_valid(whole_grammar);
  const std::vector<Grid>& grids = design.segments.at(1).lattice->grids;
  // Six strands from 1 to 3: 2 - cos(60 j degrees).
  const std::vector<double> cosine = {1, 1.5, 2.5, 3, 2.5, 1.5};
  ASSERT_EQ(grids[0].count(), 6);
  for (int j = 0; j < 6; ++j) EXPECT_NEAR(grids[0].widths_mm[j], cosine[j], 1e-14) << j;
  // Of an odd number, the middle one belongs to the first half.
  EXPECT_EQ(grids[1].widths_mm, (std::vector<double>{1, 1, 1, 2, 2}));
}

TEST(ReadDesign, LoadHoldsTheSweepThenTheCasesThenTheGrid) {
  const Design design = read_valid(whole_grammar);
  ASSERT_EQ(design.load.size(), 12U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(design.load[i].pressures_kpa, std::vector<double>(3, 20.0 * i));
  }
  EXPECT_EQ(design.load[4].pressures_kpa, (std::vector<double>{10, -20, 30.5}));
  EXPECT_EQ(design.load[5].pressures_kpa, std::vector<double>(3, 7.0));
  const std::vector<std::vector<double>> grid = {{5, 0, -3},  {5, 25, -3},  {5, 50, -3},
                                                 {15, 0, -3}, {15, 25, -3}, {15, 50, -3}};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(design.load[6 + i].pressures_kpa, grid[i]) << i;
}

TEST(ReadDesign, SettingsOfTheWholeGrammar) {
  const Design design = read_valid(whole_grammar);
  EXPECT_EQ(design.model.wall, WallKind::mixture);
  EXPECT_EQ(design.model.columns, ColumnModel::distributed);
  EXPECT_EQ(design.model.joint, JointModel::paper);
  EXPECT_TRUE(design.make.lattice);
  EXPECT_TRUE(design.make.liner);
  EXPECT_TRUE(design.make.flat_pattern);
  ASSERT_TRUE(design.make.lattice_mold);
  EXPECT_EQ(design.make.lattice_mold->pieces, 3);
  EXPECT_EQ(design.make.lattice_mold->wall_mm, 4);
  EXPECT_EQ(design.make.lattice_mold->method, MoldMethod::replica);
  ASSERT_TRUE(design.make.liner_mold);
  EXPECT_EQ(design.make.liner_mold->wall_mm, 6);
  EXPECT_EQ(design.make.liner_mold->ends, LinerEnds::closed);
  EXPECT_FALSE(design.make.liner_mold->keyed);
  EXPECT_EQ(design.make.liner_mold->pieces, 4);
  ASSERT_TRUE(design.make.preview);
  ASSERT_EQ(design.make.preview->cases.size(), 3U);
  EXPECT_EQ(design.make.preview->cases[0].pressures_kpa, std::vector<double>(3, 0.0));
  EXPECT_EQ(design.make.preview->cases[1].pressures_kpa, (std::vector<double>{20, 0, -5}));
  EXPECT_EQ(design.make.preview->cases[2].pressures_kpa, std::vector<double>(3, 40.0));
  EXPECT_TRUE(design.make.report);
  EXPECT_EQ(design.output.formats,
            (std::vector<MeshFormat>{MeshFormat::stl, MeshFormat::obj, MeshFormat::three_mf,
                                     MeshFormat::ply, MeshFormat::glb}));
  EXPECT_EQ(design.output.tolerance_mm, 0.02);
  EXPECT_EQ(design.printer.process, Process::sla);
  EXPECT_EQ(design.printer.min_wall_mm, 0.8);
  EXPECT_EQ(design.printer.min_gap_mm, 0.4);
  EXPECT_EQ(design.printer.clearance_mm, 0.2);
  EXPECT_EQ(design.printer.bed_mm, (std::array<double, 3>{200, 210, 220}));
}

TEST(ReadDesign, WhatIsLeftOutHasItsDefault) {
  const Design design = read_valid(smallest_design);
  EXPECT_TRUE(design.load.empty());
  EXPECT_EQ(design.model.wall, WallKind::layered);
  EXPECT_EQ(design.model.columns, ColumnModel::distributed);
  EXPECT_EQ(design.model.joint, JointModel::clear_span);
  EXPECT_FALSE(design.make.lattice || design.make.liner || design.make.report);
  EXPECT_FALSE(design.make.flat_pattern);
  EXPECT_FALSE(design.make.lattice_mold || design.make.liner_mold || design.make.preview);
  EXPECT_EQ(design.output.formats, std::vector<MeshFormat>{MeshFormat::stl});
  EXPECT_EQ(design.output.tolerance_mm, 0.01);
  EXPECT_EQ(design.printer.process, Process::fdm);
  EXPECT_FALSE(design.printer.min_wall_mm || design.printer.min_gap_mm);
  EXPECT_FALSE(design.printer.clearance_mm || design.printer.bed_mm);
}

TEST(ReadDesign, EmptyMoldTablesTakeTheirDefaults) {
  const Design design =
      read_valid(replaced(replaced(whole_grammar, "{ pieces = 3, wall = 4, method = \"replica\" }",
                                   R"({ pieces = "auto" })"),
                          "{ wall = 6, ends = \"closed\", keyed = false, pieces = 4 }", "{}"));
  EXPECT_FALSE(design.make.lattice_mold->pieces);
  EXPECT_EQ(design.make.lattice_mold->wall_mm, 5);
  EXPECT_EQ(design.make.lattice_mold->method, MoldMethod::direct);
  EXPECT_EQ(design.make.liner_mold->wall_mm, 5);
  EXPECT_EQ(design.make.liner_mold->ends, LinerEnds::open);
  EXPECT_FALSE(design.make.liner_mold->keyed);
  EXPECT_EQ(design.make.liner_mold->pieces, 2);
}

TEST(ReadDesign, ALinerMoldMayBeKeyedOrFlangedWhereThereIsALattice) {
  const std::string tube = std::string(smallest_design) +
                           "[segment.lattice]\nthickness = 2\nmaterial = \"hei-cast-8400\"\n"
                           "[segment.lattice.rings]\ncount = 3\nwidth = 2\n[make]\n";
  EXPECT_TRUE(read_valid(tube + "liner_mold = { keyed = true }\n").make.liner_mold->keyed);
  const Design flanged = read_valid(tube + "liner_mold = { ends = \"flanged\" }\n");
  EXPECT_EQ(flanged.make.liner_mold->ends, LinerEnds::flanged);
}

TEST(ReadDesign, ClearanceIsThatOfTheProcessUnlessGiven) {
  Printer printer;
  EXPECT_EQ(fit_clearance_mm(printer), 0.3);
  printer.process = Process::sla;
  EXPECT_EQ(fit_clearance_mm(printer), 0.15);
  EXPECT_EQ(fit_clearance_mm(read_valid(whole_grammar).printer), 0.2);
}

TEST(ReadDesign, RodsTakeALinearLiner) {
  std::string text = replaced(smallest_design, "ecoflex-00-50", "ecoflex-00-50-linear");
  const Design design = read_valid(text + "[model]\ncolumns = \"rods\"\n");
  const auto& law = std::get<Linear>(design.segments.at(0).liner.material.law);
  EXPECT_EQ(law.youngs_modulus_mpa, 0.082);
  EXPECT_EQ(law.poisson_ratio, 0.499);
}

TEST(ReadDesign, SuctionSweepsDownwards) {
  const std::string load = "[load]\npressure = { from = 0, to = -30, step = -15 }\n";
  const Design design = read_valid(std::string(smallest_design) + load);
  ASSERT_EQ(design.load.size(), 3U);
  EXPECT_EQ(design.load[2].pressures_kpa, std::vector<double>{-30});
}

TEST(ReadDesign, OrderOfTablesAndLineEndsDoNotMatter) {
  std::string text = "[model]\njoint = \"none\"\n[export]\ntolerance = 0.1\n";
  text += std::string(smallest_design).substr(smallest_design.find('\n') + 1);
  text = "\xEF\xBB\xBFname = \"tube\"\n" + text;
  std::string dos;
  for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const Design design = read_valid(dos);
  EXPECT_EQ(design.name, "tube");
  EXPECT_EQ(design.model.joint, JointModel::none);
  EXPECT_EQ(design.output.tolerance_mm, 0.1);
  EXPECT_EQ(design.segments.size(), 1U);
}

TEST(ReadDesign, TheExamplesAreValid) {
  const std::filesystem::path folder = std::filesystem::path(LATTICAST_SOURCE_DIR) / "examples";
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const ReadResult result = read_design_file(entry.path(), built_in_materials());
    for (const Issue& issue : result.issues) {
      ADD_FAILURE() << describe(issue, entry.path().filename().string());
    }
    ++read;
  }
  EXPECT_GE(read, 2);
}

TEST(ReadDesignFile, FilesThatCannotBeRead) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::filesystem::path missing = folder / "latticast-no-such-file.toml";
  try {
    read_design_file(missing, built_in_materials());
    FAIL() << "a missing file was read";
  } catch (const FileError& error) {
    EXPECT_EQ(error.path, missing);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
  try {
    read_design_file(folder, built_in_materials());
    FAIL() << "a directory was read";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("is a directory"), std::string::npos) << error.what();
  }
}

TEST(ReadDesignFile, EndlessFileIsRefusedAsTooLarge) {
  const ReadResult result = read_design_file("/dev/zero", built_in_materials());
  ASSERT_EQ(result.issues.size(), 1U);
  EXPECT_NE(result.issues[0].rule.find("larger than 4000000 bytes"), std::string::npos);
}

TEST(ReadDesign, SinusoidsHaveAmplitudeAndWaves) {
  std::string text(whole_grammar);
  const std::string horseshoe = "horseshoe = { radius = 3 }";
  text.replace(text.find(horseshoe), horseshoe.size(),
               "sinusoid = { amplitude = 1.25, waves = 6.5 }");
  const Design design = read_valid(text);
  const auto& path = std::get<Sinusoid>(design.segments[1].lattice->grids[1].path);
  EXPECT_EQ(path.amplitude_mm, 1.25);
  EXPECT_EQ(path.waves, 6.5);
}

}  // namespace
}  // namespace latticast
