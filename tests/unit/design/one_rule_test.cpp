// SPDX-License-Identifier: GPL-3.0-or-later
// One wrong design per rule: exactly that rule must be named, at its line and key.
#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "design/read_design.h"
#include "tests/unit/design/example_design.h"

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

std::ostream& operator<<(std::ostream& out, const BadDesign& bad) {
  return out << bad.name;
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
    {"NameThatTurnsItself", "\"two-segments\"", R"("a\u202Elts.exe")", "name",
     "turn the direction of writing", ""},
    {"NameForNoCard", "\"two-segments\"", R"("a:b")", "name", "memory cards refuse", ""},
    {"NameOfADevice", "\"two-segments\"", R"("con")", "name", "keeps for a device", ""},
    {"NameOfAPort", "\"two-segments\"", R"("Com1.x")", "name", "keeps for a device", ""},
    {"SegmentNameNoWord", "length = 85", "length = 85\nname = \"1st\"", "segment[0].name",
     "must be a letter, then letters", "\"tip\"", 1},
    {"GridNameTwice", "angle = 36",
     "angle = 36\n    name = \"a\"\n    count = 8\n    width = 2\n"
     "    [[segment.lattice.grid]]\n    name = \"a\"\n    angle = 140",
     "segment[0].lattice.grid[1].name", "the name of two", "its own", 5},
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
    {"FlatPatternIsText", "flat_pattern = true", "flat_pattern = \"svg\"", "make.flat_pattern",
     "true or false", ""},
    {"FlatPatternIsATable", "flat_pattern = true", "flat_pattern = {}", "make.flat_pattern",
     "true or false", ""},
    {"FlatPatternMisspelt", "flat_pattern = true", "flat-pattern = true", "make.flat-pattern",
     "not a known key", "did you mean flat_pattern?"},
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
    {"YeohC1Zero", "c1 = 0.02", "c1 = 0", "segment[1].liner.material.c1", "0.000001", ""},
    {"YeohC1Negative", "c1 = 0.02", "c1 = -0.02", "segment[1].liner.material.c1", "0.000001", ""},
    {"YeohC2Infinite", "c2 = -0.001", "c2 = -inf", "segment[1].liner.material.c2", "MPa", ""},
    {"PoissonTooLarge", "nu = 0.4", "nu = 0.51", "segment[1].lattice.material.nu", "from 0 to 0.5",
     ""},
    {"PoissonNegative", "nu = 0.4", "nu = -0.1", "segment[1].lattice.material.nu", "0 to 0.5", ""},
    {"YoungZero", "E = 30", "E = 0", "segment[1].lattice.material.E", "MPa", ""},
    {"LatticeOfRubber", "\"hei-cast-8400\"", "\"ecoflex-00-30\"", "segment[0].lattice.material",
     "must be linear; this material is neo-hookean", "hei-cast-8400"},
    {"LinerLinear", "{ law = \"gent\", mu = 0.05, jm = 40, shrinkage = 0.004 }",
     "\"hei-cast-8400\"", "segment[2].liner.material", "must be a rubber", "ecoflex-00-50"},
};

const BadDesign of_lattices[] = {
    {"FilletZero", "fillet = 0.5", "fillet = 0", "segment[0].lattice.fillet", "0.001", ""},
    {"FilletNegative", "fillet = 0.5", "fillet = -1", "segment[0].lattice.fillet", "0.001", ""},
    {"FilletIsText", "fillet = 0.5", "fillet = \"round\"", "segment[0].lattice.fillet", "number",
     ""},
    {"FilletAsLargeAsTheTube", "fillet = 0.5", "fillet = 17", "segment[0].lattice.fillet",
     "less than the lattice's mid radius, 17 mm", "smaller radius"},
    {"FilletBelowTheTolerance", "fillet = 0.5\n", "fillet = 0.02\n", "export.tolerance",
     "finer than the thinnest layer, strand, ring or fillet, 0.02 mm", "finer", 76},
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
    {"RingPitchTooLarge", "pitch = 10\n    width = 1\n    phase = 0.25",
     "pitch = 121\n    width = 1", "segment[1].lattice.rings.pitch", "at least one ring",
     "half a pitch"},
    {"RingPhaseTooLate", "pitch = 10\n    width = 1\n    phase = 0.25",
     "pitch = 70\n    width = 1\n    phase = 0.9", "segment[1].lattice.rings.pitch",
     "would end at 63.5 mm of 60.5 mm", "another phase"},
    {"RingPhaseOne", "phase = 0.25", "phase = 1", "segment[1].lattice.rings.phase",
     "from 0 to 1, 1 not included", ""},
    {"RingPhaseNegative", "phase = 0.25", "phase = -0.1", "segment[1].lattice.rings.phase",
     "from 0 to 1", ""},
    {"RingPhaseOfCountedRings", "pitch = 10\n    width = 1", "count = 6\n    width = 1",
     "segment[1].lattice.rings.phase", "flush with both ends", "a pitch in place of count", 2},
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
     "segment[0].lattice.grid[1].width", "neighbouring strands must not touch, but strands 3 and 1",
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
    {"SinusoidNeedsWaves", "horseshoe = { radius = 3 }", "sinusoid = { amplitude = 2 }",
     "segment[1].lattice.grid[1].sinusoid.waves", "must be given", "waves = 8"},
    {"SinusoidWavesAreHalves", "horseshoe = { radius = 3 }",
     "sinusoid = { amplitude = 2, waves = 3.3 }", "segment[1].lattice.grid[1].sinusoid.waves",
     "whole or half", "waves = 3.5"},
    {"SinusoidWavesTooFew", "horseshoe = { radius = 3 }", "sinusoid = { amplitude = 2, waves = 0 }",
     "segment[1].lattice.grid[1].sinusoid.waves", "from 0.5 to 5000", ""},
    {"SinusoidAmplitudeOfNothing", "horseshoe = { radius = 3 }",
     "sinusoid = { amplitude = 0, waves = 3 }", "segment[1].lattice.grid[1].sinusoid.amplitude",
     "0.001", ""},
    {"TwoPaths", "horseshoe = { radius = 3 }",
     "horseshoe = { radius = 3 }\nsinusoid = { amplitude = 2, waves = 3 }",
     "segment[1].lattice.grid[1].sinusoid", "one path", "keep horseshoe or sinusoid", 1},
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
     "more than 100000 pressures; this one holds 1000000000000", "larger step"},
    {"SweepStepDenormal", "step = 20", "step = 1e-320", "load.pressure.step", "more than 100000",
     ""},
    {"SweepEndAbsurd", "to = 60", "to = 1e300", "load.pressure.to", "100000 kPa", ""},
    {"SweepWithoutStep", "to = 60, step = 20", "to = 60", "load.pressure.step", "must be given",
     ""},
    {"CaseForTwoSegments", "[10, -20, 30.5]", "[10, -20]", "load.case[0].pressure",
     "one pressure per segment: 2 for 3 segments", "single number"},
    {"CasePressureNan", "[10, -20, 30.5]", "[10, nan, 30.5]", "load.case[0].pressure[1]", "kPa",
     ""},
    {"GridForTwoSegments", "50, step = 25 }, -3]", "50, step = 25 }]", "load.grid",
     "one entry per segment: 2 for 3 segments", "grid = ["},
    {"GridIsANumber", "grid = [[5, 15], { from = 0, to = 50, step = 25 }, -3]", "grid = 5",
     "load.grid", "list", "one entry per segment"},
    {"GridPressureNan", "[5, 15]", "[5, nan]", "load.grid[0][1]", "kPa", ""},
    {"GridTooLarge", "step = 25 }, -3]", "step = 25 }, { from = 0, to = 100, step = 0.002 }]",
     "load.grid", "more than 100000 cases; this one makes 300006", "larger steps"},
    {"KindUnknown", "kind = \"mixture\"", "kind = \"layerd\"", "model.kind",
     "\"layered\" or \"mixture\"", "did you mean layered?"},
    {"CalibrateOfAMixture", "kind = \"mixture\"", "kind = \"mixture\"\ncalibrate = true",
     "model.calibrate", "kind = \"bonded\"", "leave it out", 1},
    {"CalibrateUnknown", "kind = \"mixture\"", "kind = \"bonded\"\ncalibrate = \"stat\"",
     "model.calibrate", "true, false or \"state\"", "calibrate = \"state\"", 1},
    {"CalibrateIsANumber", "kind = \"mixture\"", "kind = \"bonded\"\ncalibrate = 1",
     "model.calibrate", "true, false or \"state\"", "calibrate = \"state\"", 1},
    {"CellOfAMixture", "kind = \"mixture\"", "kind = \"mixture\"\ncell = { error = 3 }",
     "model.cell", "kind = \"unit-cell\"", "leave it out", 1},
    {"CellErrorTooSmall", "kind = \"mixture\"", "kind = \"unit-cell\"\ncell = { error = 0.001 }",
     "model.cell.error", "0.05", "", 1},
    {"ColumnsUnknown", "columns = \"distributed\"", "columns = 1", "model.columns",
     "\"distributed\" or \"rods\"", "quotes"},
    {"JointUnknown", "joint = \"paper\"", "joint = \"Paper\"", "model.joint", "\"clear-span\"",
     "did you mean paper?"},
    {"DeckIsTrue", "lattice = true", "lattice = true\ndeck = true", "make.deck", "must be a table",
     "formats", 1},
    {"DeckFormatUnknown", "lattice = true",
     "lattice = true\ndeck = { formats = [\"inp\", \"bdf\"] }", "make.deck.formats[1]",
     "\"inp\" or \"msh\"", "", 1},
    {"DeckPartUnknown", "lattice = true", "lattice = true\ndeck = { part = \"cell\" }",
     "make.deck.part", "\"sector\" or \"actuator\"", "", 1},
    {"MakeLatticeAsWord", "lattice = true", "lattice = \"yes\"", "make.lattice", "true or false",
     ""},
    {"MoldIsTrue", "lattice_mold = { pieces = 3, wall = 4, method = \"replica\" }",
     "lattice_mold = true", "make.lattice_mold", "must be a table", "pieces"},
    {"MoldPiecesOne", "pieces = 3", "pieces = 1", "make.lattice_mold.pieces", "from 2 to 100", ""},
    {"MoldPiecesWord", "pieces = 3", "pieces = \"some\"", "make.lattice_mold.pieces", "\"auto\"",
     ""},
    {"MoldWallZero", "wall = 6", "wall = 0", "make.liner_mold.wall", "0.001", ""},
    {"MoldWallNotBeyondTheClearance", "wall = 6", "wall = 0.2", "make.liner_mold.wall",
     "clearance, 0.2 mm, must be less than the mold's wall, 0.2 mm", "thicker wall"},
    {"LatticeMoldWallNotBeyondTheClearance", "wall = 4", "wall = 0.1", "make.lattice_mold.wall",
     "clearance, 0.2 mm, must be less than the mold's wall, 0.1 mm", "printer.clearance"},
    {"MoldMethodUnknown", "\"replica\"", "\"replca\"", "make.lattice_mold.method",
     "\"direct\" or \"replica\"", "did you mean replica"},
    {"GrooveDeeperThanTheWall", "wall = 4, method = \"replica\"", "wall = 2",
     "make.lattice_mold.wall", "strands 2 mm deep need more wall behind them than 2 mm",
     "thicker than the lattice"},
    {"LinerMoldPiecesOne", "keyed = false, pieces = 4", "keyed = false, pieces = 1",
     "make.liner_mold.pieces", "from 2 to 100", ""},
    {"LinerEndsUnknown", "\"closed\"", "\"close\"", "make.liner_mold.ends", "\"flanged\"",
     "did you mean closed"},
    {"ClosedLinerTooShort", "length = 20", "length = 3", "make.liner_mold.ends",
     "3 mm is not more than 3 mm", "longer segment", 25},
    {"FlangesWithoutALattice", "\"closed\"", "\"flanged\"", "make.liner_mold.ends",
     "on every segment", "segment.lattice"},
    {"KeyedWithoutALattice", "keyed = false", "keyed = true", "make.liner_mold.keyed",
     "on every segment", "segment.lattice"},
    {"KeyedBetweenFlanges", "ends = \"closed\", keyed = false", "ends = \"flanged\", keyed = true",
     "make.liner_mold.keyed", "hang between the flanges", "open"},
    {"KeyedIsAWord", "keyed = false", "keyed = \"no\"", "make.liner_mold.keyed", "true or false",
     ""},
    {"ShrinkageTooLarge", "shrinkage = 0.004", "shrinkage = 0.4",
     "segment[2].liner.material.shrinkage", "from 0 to 0.2", ""},
    {"PreviewWithoutPressures", "preview = { pressures = [0, [20, 0, -5], 40] }", "preview = {}",
     "make.preview.pressures", "must be given", ""},
    {"PreviewEmpty", "pressures = [0, [20, 0, -5], 40]", "pressures = []", "make.preview.pressures",
     "1 to 1000 entries", ""},
    {"PreviewForTwoSegments", "[20, 0, -5]", "[20, 0]", "make.preview.pressures[1]",
     "one pressure per segment: 2 for 3 segments", "single number"},
    {"PreviewPressureAbsurd", "pressures = [0, [20, 0, -5], 40]",
     "pressures = [0, [20, 0, -5], 1e6]", "make.preview.pressures[2]", "100000 kPa", ""},
    {"FormatUnknown", "\"stl\", \"obj\"", "\"slt\", \"obj\"", "export.formats[0]", "\"stl\" or",
     "did you mean stl"},
    {"FormatTwice", "\"stl\", \"obj\"", "\"stl\", \"stl\"", "export.formats[1]", "named twice", ""},
    {"FormatsEmpty", "[\"stl\", \"obj\", \"3mf\", \"ply\", \"glb\"]", "[]", "export.formats",
     "1 to 20 entries", ""},
    {"FormatsAsText", "[\"stl\", \"obj\", \"3mf\", \"ply\", \"glb\"]", "\"stl\"", "export.formats",
     "must be a list", "[\"stl\", \"obj\"]"},
    {"ToleranceTooFine", "tolerance = 0.02", "tolerance = 1e-6", "export.tolerance",
     "from 0.00001 to 1", ""},
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

}  // namespace
}  // namespace latticast
