// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong designs whose problem is more than one wrong word, and many problems at once.
#include <gtest/gtest.h>

#include "design/read_design.h"
#include "tests/unit/design/example_design.h"

namespace latticast {
namespace {

std::vector<Issue> issues_of(const std::string& text) {
  return read_design(text, built_in_materials()).issues;
}

Issue only_issue_of(const std::string& text) {
  const std::vector<Issue> issues = issues_of(text);
  std::string all;
  for (const Issue& issue : issues) all += describe(issue, "\n");
  EXPECT_EQ(issues.size(), 1U) << all;
  return issues.empty() ? Issue{} : issues[0];
}

TEST(BadDesign, RingsByBothAreBlamedOnThePitch) {
  const Issue issue =
      only_issue_of(replaced(whole_grammar, "width = 2.5", "pitch = 10\n    width = 2.5"));
  EXPECT_EQ(issue.key, "segment[0].lattice.rings.pitch");
  EXPECT_EQ(issue.value, "10");
  EXPECT_NE(issue.rule.find("exactly one"), std::string::npos);
}

TEST(BadDesign, SegmentAsASingleTable) {
  const Issue issue = only_issue_of(replaced(smallest_design, "[[segment]]", "[segment]"));
  EXPECT_EQ(issue.key, "segment");
  EXPECT_EQ(issue.line, 2);
  EXPECT_NE(issue.hint.find("[[segment]]"), std::string::npos);
}

TEST(BadDesign, NoSegments) {
  EXPECT_EQ(only_issue_of("name = \"a\"\n").key, "segment");
  EXPECT_EQ(only_issue_of("name = \"a\"\nsegment = []\n").line, 2);
}

TEST(BadDesign, SegmentThatIsNoTable) {
  const Issue issue = only_issue_of("name = \"a\"\nsegment = [3]\n");
  EXPECT_EQ(issue.key, "segment[0]");
  EXPECT_EQ(issue.value, "3");
}

TEST(BadDesign, TooManySegments) {
  std::string text = "name = \"a\"\n";
  for (int i = 0; i < 101; ++i) text += "[[segment]]\nlength = 5\n";
  const Issue issue = only_issue_of(text);
  EXPECT_NE(issue.rule.find("1 to 100 entries; this one holds 101"), std::string::npos);
}

TEST(BadDesign, LatticeWithoutRingsAndGrids) {
  const std::string lattice = "[segment.lattice]\nthickness = 1\nmaterial = \"hei-cast-8400\"\n";
  const Issue issue = only_issue_of(std::string(smallest_design) + lattice);
  EXPECT_EQ(issue.key, "segment[0].lattice");
  EXPECT_EQ(issue.line, 8);
  EXPECT_NE(issue.rule.find("rings or at least one grid"), std::string::npos);
}

TEST(BadDesign, CrossingsBeyondCounting) {
  const std::string lattice = R"([segment.lattice]
thickness = 1
material = "hei-cast-8400"
[segment.lattice.rings]
count = 2000
width = 0.001
[[segment.lattice.grid]]
angle = 90
count = 2000
width = 0.001
[export]
tolerance = 1e-4
)";
  const Issue issue = only_issue_of(std::string(smallest_design) + lattice);
  EXPECT_EQ(issue.key, "segment[0].lattice");
  EXPECT_NE(issue.rule.find("about 4000000 times"), std::string::npos) << issue.rule;
}

TEST(BadDesign, RingsBeyondCountingByPitch) {
  const std::string lattice = R"([segment.lattice]
thickness = 1
material = "hei-cast-8400"
[segment.lattice.rings]
pitch = 0.004
width = 0.002
[export]
tolerance = 1e-4
)";
  const Issue issue = only_issue_of(std::string(smallest_design) + lattice);
  EXPECT_EQ(issue.key, "segment[0].lattice.rings.pitch");
  EXPECT_NE(issue.rule.find("more than 10000 rings; this one gives 12500"), std::string::npos)
      << issue.rule;
}

TEST(BadDesign, MakingALatticeThatIsNotThere) {
  const std::string text =
      std::string(smallest_design) +
      "[make]\nlattice = true\nflat_pattern = true\nlattice_mold = {}\nliner = true\n";
  const std::vector<Issue> issues = issues_of(text);
  ASSERT_EQ(issues.size(), 3U);
  EXPECT_EQ(issues[0].key, "make.lattice");
  EXPECT_EQ(issues[1].key, "make.flat_pattern");
  EXPECT_EQ(issues[2].key, "make.lattice_mold");
}

TEST(BadDesign, DefaultWallOfAMoldIsBlamedOnTheMold) {
  const std::string lattice = R"([segment.lattice]
thickness = 5
material = "hei-cast-8400"
[segment.lattice.rings]
count = 2
width = 2
)";
  const Issue deep =
      only_issue_of(std::string(smallest_design) + lattice + "[make]\nlattice_mold = {}\n");
  EXPECT_EQ(deep.key, "make.lattice_mold");
  EXPECT_NE(deep.rule.find("5 mm deep"), std::string::npos) << deep.rule;
  const Issue loose = only_issue_of(std::string(smallest_design) +
                                    "[make]\nliner_mold = {}\n[printer]\nclearance = 6\n");
  EXPECT_EQ(loose.key, "make.liner_mold");
  EXPECT_NE(loose.rule.find("clearance, 6 mm"), std::string::npos) << loose.rule;
}

TEST(BadDesign, ReplicasHaveNoGroovesInTheWall) {
  const std::string replica = R"([segment.lattice]
thickness = 5
material = "hei-cast-8400"
[segment.lattice.rings]
count = 2
width = 2
[make]
lattice_mold = { method = "replica" }
)";
  EXPECT_TRUE(issues_of(std::string(smallest_design) + replica).empty());
}

TEST(BadDesign, RodsRefuseARubberLiner) {
  const Issue issue = only_issue_of(std::string(smallest_design) + "[model]\ncolumns = \"rods\"\n");
  EXPECT_EQ(issue.key, "segment[0].liner.material");
  EXPECT_NE(issue.hint.find("ecoflex-00-50-linear"), std::string::npos);
}

TEST(BadDesign, DefaultToleranceTooCoarseForTheDesign) {
  const Issue issue =
      only_issue_of(replaced(smallest_design, "thickness = 2", "thickness = 0.005"));
  EXPECT_EQ(issue.line, 0);
  EXPECT_NE(issue.rule.find("export.tolerance (here 0.01 mm)"), std::string::npos) << issue.rule;
}

TEST(BadDesign, ListOfAMillionWidths) {
  std::string list = "width = [1";
  for (int i = 1; i < 1000000; ++i) list += ",1";
  const Issue issue = only_issue_of(replaced(whole_grammar, "width = [1, 1.5, 2]", list + "]"));
  EXPECT_EQ(issue.key, "segment[0].lattice.grid[1].width");
  EXPECT_NE(issue.rule.find("this one holds 1000000"), std::string::npos);
  EXPECT_LT(issue.value.size(), 100U);
}

TEST(BadDesign, SyntaxErrorsNameTheirLine) {
  EXPECT_EQ(only_issue_of("name = \"a\"\nname = \"b\"\n").line, 2);
  EXPECT_EQ(only_issue_of("name = \"a\"\n[make]\n[printer]\n[make]\n").line, 4);
  EXPECT_EQ(only_issue_of("name = \"a\"\n\nlength = = 3\n").line, 3);
  EXPECT_EQ(only_issue_of("name = \"a\xff\"\n").line, 1);
}

TEST(BadDesign, NothingMoreThanMissingKeysInAnEmptyFile) {
  const std::vector<Issue> issues = issues_of("");
  ASSERT_EQ(issues.size(), 2U);
  EXPECT_EQ(issues[0].key, "name");
  EXPECT_EQ(issues[1].key, "segment");
  for (const Issue& issue : issues) {
    EXPECT_EQ(issue.line, 0);
    EXPECT_EQ(issue.value, "");
  }
}

TEST(BadDesign, EveryProblemAtOnceInFileOrder) {
  const std::string text = R"(name = "../escape"
colour = "red"
[[segment]]
lenght = 85
  [segment.liner]
  inner_radius = -12
  thickness = "4 mm"
  material = "ecoflex-0050"
  [segment.lattice]
  thickness = nan
  material = "ecoflex-00-50"
    [segment.lattice.rings]
    count = 1000000000
    width = 2
    [[segment.lattice.grid]]
    angle = 200
    width = { from = 1, to = 2, profile = "cos" }
    horseshoe = { radius = 0, arc = 5, alternat = true }
[printer]
bed = [1, 2]
[load]
pressure = { from = 0, to = 60, step = 0 }
[model]
joint = "rigid"
[make]
lattice = 1
preview = { pressures = [0, inf] }
[export]
formats = ["stl", "stl", "sdl"]
tolerance = 5
)";
  struct Expected {
    int line;
    const char* key;
    const char* value;
  };
  const Expected expected[] = {
      {1, "name", "\"../escape\""},
      {2, "colour", "\"red\""},
      {3, "segment[0].length", ""},
      {4, "segment[0].lenght", "85"},
      {6, "segment[0].liner.inner_radius", "-12"},
      {7, "segment[0].liner.thickness", "\"4 mm\""},
      {8, "segment[0].liner.material", "\"ecoflex-0050\""},
      {10, "segment[0].lattice.thickness", "nan"},
      {11, "segment[0].lattice.material", "\"ecoflex-00-50\""},
      {13, "segment[0].lattice.rings.count", "1000000000"},
      {15, "segment[0].lattice.grid[0].count", ""},
      {16, "segment[0].lattice.grid[0].angle", "200"},
      {17, "segment[0].lattice.grid[0].width.profile", "\"cos\""},
      {18, "segment[0].lattice.grid[0].horseshoe.radius", "0"},
      {18, "segment[0].lattice.grid[0].horseshoe.arc", "5"},
      {18, "segment[0].lattice.grid[0].horseshoe.alternat", "true"},
      {20, "printer.bed", "[1, 2]"},
      {22, "load.pressure.step", "0"},
      {24, "model.joint", "\"rigid\""},
      {26, "make.lattice", "1"},
      {27, "make.preview.pressures[1]", "inf"},
      {29, "export.formats[1]", "\"stl\""},
      {29, "export.formats[2]", "\"sdl\""},
      {30, "export.tolerance", "5"},
  };
  const std::vector<Issue> issues = issues_of(text);
  std::string all;
  for (const Issue& issue : issues) all += describe(issue, "\n");
  ASSERT_EQ(issues.size(), std::size(expected)) << all;
  for (std::size_t i = 0; i < issues.size(); ++i) {
    EXPECT_EQ(issues[i].line, expected[i].line) << all;
    EXPECT_EQ(issues[i].key, expected[i].key) << all;
    EXPECT_EQ(issues[i].value, expected[i].value) << all;
  }
}

}  // namespace
}  // namespace latticast
