// SPDX-License-Identifier: GPL-3.0-or-later
// One wrong design per rule: exactly that rule must be named, at its line and key.
#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "spec/read_design.h"
#include "tests/unit/spec/example_design.h"

namespace latticast {
namespace {

struct BadDesign {
  const char* name;   ///< of the test
  const char* old;    ///< what stands in the good design
  const char* wrong;  ///< what stands there instead
  const char* key;
  const char* rule;     ///< part of the rule
  const char* hint;     ///< part of the hint
  int lines_below = 0;  ///< from the line where `old` begins to the line to be named
};

void PrintTo(const BadDesign& bad, std::ostream* out) {
  *out << bad.name;
}

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + at, '\n'));
}

class OneRule : public testing::TestWithParam<BadDesign> {};

TEST_P(OneRule, IsNamedAloneWithItsPlace) {
  const BadDesign& bad = GetParam();
  const std::string text = replaced(whole_grammar, bad.old, bad.wrong);
  const ReadResult result = read_design(text, built_in_materials());
  std::string all;
  for (const Issue& issue : result.issues) all += describe(issue, "\n");
  ASSERT_EQ(result.issues.size(), 1U) << all;
  const Issue& issue = result.issues[0];
  EXPECT_EQ(issue.key, bad.key);
  EXPECT_NE(issue.rule.find(bad.rule), std::string::npos) << all;
  EXPECT_NE(issue.hint.find(bad.hint), std::string::npos) << all;
  EXPECT_FALSE(issue.hint.empty());
  EXPECT_EQ(issue.line, line_of(whole_grammar, whole_grammar.find(bad.old)) + bad.lines_below)
      << all;
}

const BadDesign of_names_and_shapes[] = {
    {"NameWithSlash", "\"two-segments\"", "\"a/b\"", "name", "path separator", "twisting-36"},
    {"NameWithBackslash", "\"two-segments\"", R"("a\\b")", "name", "path separator", ""},
    {"NameEmpty", "\"two-segments\"", "\"\"", "name", "1 to 100 bytes", ""},
    {"NameDot", "\"two-segments\"", "\".\"", "name", "start with a point", ""},
    {"NameDotDot", "\"two-segments\"", "\"..\"", "name", "start with a point", ""},
    {"NameHidden", "\"two-segments\"", "\".a\"", "name", "start with a point", ""},
    {"NameLikeAnOption", "\"two-segments\"", "\"-o\"", "name", "a minus", ""},
    {"NameWithLineEnd", "\"two-segments\"", R"("a\nb")", "name", "control characters", ""},
    {"NameWithNul", "\"two-segments\"", R"("a\u0000b")", "name", "control characters", ""},
    {"NameWithDelete", "\"two-segments\"", R"("a\u007F")", "name", "control characters", ""},
    {"NameWithC1", "\"two-segments\"", R"("a\u0085b")", "name", "control characters", ""},
    {"NameEndingInSpace", "\"two-segments\"", "\"a \"", "name", "space", ""},
    {"NameTooLong", "\"two-segments\"",
     "\"01234567890123456789012345678901234567890123456789"
     "012345678901234567890123456789012345678901234567890\"",
     "name", "1 to 100 bytes", ""},
    {"NameIsANumber", "\"two-segments\"", "36", "name", "must be text", "quotes"},
    {"UnknownTopKey", "name = \"two-segments\"", "name = \"a\"\ncolour = 1", "colour",
     "not a known key", "known keys: name", 1},
    {"UnknownQuotedKey", "report = true", "\"re port\" = true", "make.\"re port\"",
     "not a known key", "did you mean report?"},
    {"NumberAsText", "length = 60.5", "length = \"60.5\"", "segment[1].length",
     "number from 0.001 to 100000 mm", "in mm"},
    {"NumberAsDate", "length = 60.5", "length = 2020-01-01", "segment[1].length", "number", ""},
    {"LengthZero", "length = 60.5", "length = 0", "segment[1].length", "0.001", ""},
    {"LengthNegative", "length = 60.5", "length = -60.5", "segment[1].length", "0.001", ""},
    {"LengthNan", "length = 60.5", "length = nan", "segment[1].length", "0.001", ""},
    {"LengthInfinite", "length = 60.5", "length = inf", "segment[1].length", "100000", ""},
    {"LengthAbsurd", "length = 60.5", "length = 1e9", "segment[1].length", "100000", ""},
    {"LengthMisspelt", "length = 60.5", "length = 60.5\nlenth = 1", "segment[1].lenth",
     "not a known key", "did you mean length?", 1},
};

const BadDesign of_materials[] = {
    {"MaterialUnknown", "\"ecoflex-00-50\"", "\"ecoflex-0050\"", "segment[0].liner.material",
     "not in the materials library", "did you mean ecoflex-00-50"},
    {"MaterialNoName", "\"ecoflex-00-50\"", "50", "segment[0].liner.material",
     "name or an inline table", "neo-hookean"},
    {"LawUnknown", "law = \"gent\"", "law = \"gnet\"", "segment[2].liner.material.law",
     "\"linear\" or \"neo-hookean\"", "did you mean gent?"},
    {"LawMissing", "law = \"gent\", ", "", "segment[2].liner.material.law", "must be given", "law"},
    {"ConstantOfAnotherLaw", "mu = 0.05, jm = 40", "mu = 0.05, jm = 40, c1 = 1",
     "segment[2].liner.material.c1", "not a known key", "known keys: law, mu, jm"},
    {"GentWithoutJm", "mu = 0.05, jm = 40", "mu = 0.05", "segment[2].liner.material.jm",
     "must be given", "jm = "},
    {"GentJmZero", "jm = 40", "jm = 0", "segment[2].liner.material.jm", "from 0.001", ""},
    {"GentMuNegative", "mu = 0.05", "mu = -0.05", "segment[2].liner.material.mu", "MPa", ""},
    {"YeohC1Zero", "c1 = 0.02", "c1 = 0", "segment[1].liner.material.c1", "1e-06", ""},
    {"YeohC1Negative", "c1 = 0.02", "c1 = -0.02", "segment[1].liner.material.c1", "1e-06", ""},
    {"YeohC2Infinite", "c2 = -0.001", "c2 = -inf", "segment[1].liner.material.c2", "MPa", ""},
    {"PoissonTooLarge", "nu = 0.4", "nu = 0.51", "segment[1].lattice.material.nu", "from 0 to 0.5",
     ""},
    {"PoissonNegative", "nu = 0.4", "nu = -0.1", "segment[1].lattice.material.nu", "0 to 0.5", ""},
    {"YoungZero", "E = 30", "E = 0", "segment[1].lattice.material.E", "MPa", ""},
    {"LatticeOfRubber", "\"hei-cast-8400\"", "\"ecoflex-00-30\"", "segment[0].lattice.material",
     "must be linear; this material is neo-hookean", "hei-cast-8400"},
    {"LinerLinear", "{ law = \"gent\", mu = 0.05, jm = 40 }", "\"hei-cast-8400\"",
     "segment[2].liner.material", "must be a rubber", "ecoflex-00-50"},
};

const BadDesign of_lattices[] = {
    {"RingCountOne", "count = 8\n    width = 2.5", "count = 1\n    width = 2.5",
     "segment[0].lattice.rings.count", "whole number from 2 to 10000", ""},
    {"RingCountABillion", "count = 8\n    width = 2.5", "count = 1000000000\n    width = 2.5",
     "segment[0].lattice.rings.count", "whole number from 2 to 10000", ""},
    {"RingCountBeyondInt", "count = 8\n    width = 2.5", "count = 4294967304\n    width = 2.5",
     "segment[0].lattice.rings.count", "whole number from 2 to 10000", ""},
    {"RingCountHalf", "count = 8\n    width = 2.5", "count = 8.5\n    width = 2.5",
     "segment[0].lattice.rings.count", "whole number", ""},
    {"RingsTouch", "count = 8\n    width = 2.5", "count = 34\n    width = 2.5",
     "segment[0].lattice.rings.count", "must not touch", "fewer"},
    {"RingWiderThanSegment", "count = 8\n    width = 2.5", "count = 2\n    width = 85",
     "segment[0].lattice.rings.count", "narrower than the segment", ""},
    {"RingsByNeither", "[segment.lattice.rings]\n    count = 8\n    width",
     "[segment.lattice.rings]\n    width", "segment[0].lattice.rings",
     "exactly one of count and pitch", ""},
    {"RingPitchTooSmall", "pitch = 10\n    width = 1", "pitch = 1\n    width = 1",
     "segment[1].lattice.rings.pitch", "more than the rings' width", ""},
    {"RingPitchTooLarge", "pitch = 10\n    width = 1", "pitch = 121\n    width = 1",
     "segment[1].lattice.rings.pitch", "at least one ring", "half a pitch"},
    {"AngleZero", "angle = 36", "angle = 0", "segment[0].lattice.grid[0].angle",
     "between 0 and 180 degrees, neither included", ""},
    {"AngleStraight", "angle = 36", "angle = 180", "segment[0].lattice.grid[0].angle",
     "neither included", ""},
    {"AngleWindsForever", "angle = 120.5\n    width = [1, 1.5, 2]",
     "angle = 0.04\n    width = [0.03]", "segment[0].lattice.grid[1].angle", "wind around the tube",
     "steeper"},
    {"WidthZero", "count = 8\n    width = 2\n", "count = 8\n    width = 0\n",
     "segment[0].lattice.grid[0].width", "0.001", "", 1},
    {"WidthInListNegative", "width = [1, 1.5, 2]", "width = [1, -1.5, 2]",
     "segment[0].lattice.grid[1].width[1]", "0.001", ""},
    {"WidthListEmpty", "width = [1, 1.5, 2]", "width = []", "segment[0].lattice.grid[1].width",
     "1 to 10000 entries; this one holds 0", ""},
    {"WidthListAndCountDiffer", "width = [1, 1.5, 2]", "width = [1, 1.5, 2]\n    count = 4",
     "segment[0].lattice.grid[1].width", "one width per strand: 3 for 4 strands", ""},
    {"WidthProfileUnknown", "profile = \"cosine\"", "profile = \"sine\"",
     "segment[1].lattice.grid[0].width.profile", "\"cosine\" or \"halves\"", "did you mean cosine"},
    {"WidthFromMissing", "width = { from = 1, to = 3,", "width = { to = 3,",
     "segment[1].lattice.grid[0].width.from", "must be given", "from = "},
    // 2 pi 17 sin 36 = 62.78: 32 strips of 2 mm fill 1.019 of it.
    {"StrandsFillTheTube", "angle = 36\n    count = 8", "angle = 36\n    count = 32",
     "segment[0].lattice.grid[0].width", "fill 1.019 of the tube", "fewer", 2},
    // Two of three strands need (40 + 40)/2 of a share of 30.7 mm although the three fill only
    // 0.87.
    {"NeighboursTouch", "width = [1, 1.5, 2]", "width = [40, 0.1, 40]",
     "segment[0].lattice.grid[1].width", "neighbouring strands must not touch, but strands 2 and 0",
     ""},
    {"HorseshoeRadiusZero", "radius = 2.656", "radius = 0",
     "segment[1].lattice.grid[0].horseshoe.radius", "0.001", ""},
    {"HorseshoeArcSmall", "arc = 170", "arc = 19.9", "segment[1].lattice.grid[0].horseshoe.arc",
     "from 20 to 300 degrees", ""},
    {"HorseshoeArcLarge", "arc = 170", "arc = 301", "segment[1].lattice.grid[0].horseshoe.arc",
     "from 20 to 300 degrees", ""},
    {"HorseshoeArcsCountless", "radius = 2.656", "radius = 0.002",
     "segment[1].lattice.grid[0].horseshoe", "more than 10000 arcs", "larger radius"},
    {"HorseshoeIsANumber", "horseshoe = { radius = 3 }", "horseshoe = 3",
     "segment[1].lattice.grid[1].horseshoe", "must be a table", "radius"},
    {"AlternateIsANumber", "alternate = false", "alternate = 0",
     "segment[1].lattice.grid[0].horseshoe.alternate", "true or false", ""},
};

const BadDesign of_settings[] = {
    {"PressureIsAList", "pressure = { from = 0, to = 60, step = 20 }", "pressure = [0, 60]",
     "load.pressure", "a sweep", "[[load.case]]"},
    {"PressureInfinite", "pressure = { from = 0, to = 60, step = 20 }", "pressure = inf",
     "load.pressure", "-100000 to 100000 kPa", ""},
    {"SweepStepZero", "step = 20", "step = 0", "load.pressure.step", "not zero", "positive"},
    {"SweepStepBackwards", "step = 20", "step = -20", "load.pressure.step", "lead from",
     "positive"},
    {"SweepStepTiny", "to = 60, step = 20", "to = 100000, step = 1e-7", "load.pressure.step",
     "more than 100000 pressures; this one holds 1e+12", "larger step"},
    {"SweepStepDenormal", "step = 20", "step = 1e-320", "load.pressure.step", "more than 100000",
     ""},
    {"SweepEndAbsurd", "to = 60", "to = 1e300", "load.pressure.to", "100000 kPa", ""},
    {"SweepWithoutStep", "to = 60, step = 20", "to = 60", "load.pressure.step", "must be given",
     ""},
    {"CaseForTwoSegments", "[10, -20, 30.5]", "[10, -20]", "load.case[0].pressure",
     "one pressure per segment: 2 for 3 segments", "single number"},
    {"CasePressureNan", "[10, -20, 30.5]", "[10, nan, 30.5]", "load.case[0].pressure[1]", "kPa",
     ""},
    {"KindUnknown", "kind = \"mixture\"", "kind = \"layerd\"", "model.kind",
     "\"layered\" or \"mixture\"", "did you mean layered?"},
    {"ColumnsUnknown", "columns = \"distributed\"", "columns = 1", "model.columns",
     "\"distributed\" or \"rods\"", "quotes"},
    {"JointUnknown", "joint = \"paper\"", "joint = \"Paper\"", "model.joint", "\"clear-span\"",
     "did you mean paper?"},
    {"MakeLatticeAsWord", "lattice = true", "lattice = \"yes\"", "make.lattice", "true or false",
     ""},
    {"MoldIsTrue", "lattice_mold = { pieces = 3, wall = 4 }", "lattice_mold = true",
     "make.lattice_mold", "must be a table", "pieces"},
    {"MoldPiecesOne", "pieces = 3", "pieces = 1", "make.lattice_mold.pieces", "from 2 to 100", ""},
    {"MoldPiecesWord", "pieces = 3", "pieces = \"some\"", "make.lattice_mold.pieces", "\"auto\"",
     ""},
    {"MoldWallZero", "wall = 6", "wall = 0", "make.liner_mold.wall", "0.001", ""},
    {"PreviewWithoutPressures", "preview = { pressures = [0, 20, 40] }", "preview = {}",
     "make.preview.pressures", "must be given", ""},
    {"PreviewEmpty", "pressures = [0, 20, 40]", "pressures = []", "make.preview.pressures",
     "1 to 1000 entries", ""},
    {"PreviewPressureAbsurd", "pressures = [0, 20, 40]", "pressures = [0, 20, 1e6]",
     "make.preview.pressures[2]", "100000 kPa", ""},
    {"FormatUnknown", "\"stl\", \"obj\"", "\"slt\", \"obj\"", "export.formats[0]", "\"stl\" or",
     "did you mean stl"},
    {"FormatTwice", "\"stl\", \"obj\"", "\"stl\", \"stl\"", "export.formats[1]", "named twice", ""},
    {"FormatsEmpty", "[\"stl\", \"obj\", \"3mf\", \"ply\", \"glb\"]", "[]", "export.formats",
     "1 to 20 entries", ""},
    {"FormatsAsText", "[\"stl\", \"obj\", \"3mf\", \"ply\", \"glb\"]", "\"stl\"", "export.formats",
     "must be a list", "[\"stl\", \"obj\"]"},
    {"ToleranceTooFine", "tolerance = 0.02", "tolerance = 1e-6", "export.tolerance",
     "from 1e-05 to 1", ""},
    {"ToleranceTooCoarse", "tolerance = 0.02", "tolerance = 2", "export.tolerance", "to 1 mm", ""},
    // The narrowest strands are 1 mm wide.
    {"ToleranceCoarserThanAStrand", "tolerance = 0.02", "tolerance = 1", "export.tolerance",
     "finer than the thinnest", ""},
    {"ProcessUnknown", "process = \"sla\"", "process = \"SLS\"", "printer.process", "\"fdm\" or",
     ""},
    {"MinGapNegative", "min_gap = 0.4", "min_gap = -0.4", "printer.min_gap", "0.001", ""},
    {"BedOfTwo", "[200, 210, 220]", "[200, 210]", "printer.bed", "3 entries; this one holds 2", ""},
    {"BedWithZero", "[200, 210, 220]", "[200, 210, 0]", "printer.bed[2]", "0.001", ""},
};

std::string test_name(const testing::TestParamInfo<BadDesign>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(NamesAndShapes, OneRule, testing::ValuesIn(of_names_and_shapes),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Materials, OneRule, testing::ValuesIn(of_materials), test_name);
INSTANTIATE_TEST_SUITE_P(Lattices, OneRule, testing::ValuesIn(of_lattices), test_name);
INSTANTIATE_TEST_SUITE_P(Settings, OneRule, testing::ValuesIn(of_settings), test_name);

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
  EXPECT_NE(issue.rule.find("about 4e+06 times"), std::string::npos) << issue.rule;
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
      std::string(smallest_design) + "[make]\nlattice = true\nlattice_mold = {}\nliner = true\n";
  const std::vector<Issue> issues = issues_of(text);
  ASSERT_EQ(issues.size(), 2U);
  EXPECT_EQ(issues[0].key, "make.lattice");
  EXPECT_EQ(issues[1].key, "make.lattice_mold");
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
