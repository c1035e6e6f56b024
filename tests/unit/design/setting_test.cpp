// SPDX-License-Identifier: GPL-3.0-or-later
// Paths find their values, and what they do not find is told with what was probably meant.
#include "design/setting/setting.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/unit/design/example_design.h"

namespace latticast {
namespace {

using Settings = std::vector<std::string>;

ReadResult read_with(const Settings& settings, std::string_view text = whole_grammar) {
  return read_design_with(text, settings, built_in_materials());
}

std::string problems_of(const ReadResult& result) {
  std::string all;
  for (const Issue& issue : result.issues) all += describe(issue, "a.toml") + "\n";
  return all;
}

/// The design read with settings; the test fails where there is a problem.
Design design_with(const Settings& settings, std::string_view text = whole_grammar) {
  const ReadResult result = read_with(settings, text);
  EXPECT_TRUE(result.ok()) << problems_of(result);
  return result.design;
}

std::string named_grammar() {
  const std::string segment =
      replaced(whole_grammar, "length = 60.5", "length = 60.5\nname = \"tip\"");
  return replaced(segment, "angle = 120.5", "angle = 120.5\n    name = \"cross\"");
}

TEST(Settings, ReplaceValues) {
  const Design design = design_with({"segment.0.length=90", "segment.0.lattice.grid.1.angle=110",
                                     "printer.process=sla", "model.joint = none",
                                     "segment[1].liner.thickness=2.5", "name=longer"});
  EXPECT_EQ(design.segments[0].length_mm, 90);
  EXPECT_EQ(design.segments[0].lattice->grids[1].angle_deg, 110);
  EXPECT_EQ(design.segments[1].liner.thickness_mm, 2.5);
  EXPECT_EQ(design.printer.process, Process::sla);
  EXPECT_EQ(design.model.joint, JointModel::none);
  EXPECT_EQ(design.name, "longer");
}

TEST(Settings, FindEntriesByName) {
  const Design design = design_with(
      {"segment.tip.length=61", "segment.0.lattice.grid.cross.angle=100"}, named_grammar());
  EXPECT_EQ(design.segments[1].name, "tip");
  EXPECT_EQ(design.segments[1].length_mm, 61);
  EXPECT_EQ(design.segments[0].lattice->grids[1].angle_deg, 100);
}

TEST(Settings, TakeWholeTablesAndLists) {
  const Design design = design_with(
      {"load={pressure={from=0, to=30, step=10}}", "segment.0.lattice.grid.1.width=[1, 2, 1.5]",
       "segment.2.liner.material=ecoflex-00-30", "segment.0.lattice.rings={pitch=10, width=2}"});
  EXPECT_EQ(design.load.size(), 4U);
  EXPECT_EQ(design.segments[0].lattice->grids[1].widths_mm, (std::vector<double>{1, 2, 1.5}));
  EXPECT_EQ(design.segments[2].liner.material.name, "ecoflex-00-30");
  EXPECT_EQ(design.segments[0].lattice->rings->pitch_mm, 10);
}

TEST(Settings, AddKeysThatAreNotThere) {
  constexpr std::string_view tube = R"(name = "tube"
[[segment]]
length = 40
liner = { inner_radius = 10, thickness = 3, material = "ecoflex-00-50" }
)";
  const Design design =
      design_with({"export.tolerance=0.02", "make.preview.pressures=[0, 20]"}, tube);
  EXPECT_EQ(design.output.tolerance_mm, 0.02);
  EXPECT_EQ(design.make.preview->cases.size(), 2U);
}

TEST(Settings, TheLastOneHolds) {
  const Design design = design_with({"segment.0.length=90", "segment.0.length=91"});
  EXPECT_EQ(design.segments[0].length_mm, 91);
}

TEST(Settings, ValuesKeepTheRulesOfTheDesign) {
  EXPECT_EQ(problems_of(read_with({"segment.0.length=-3"})),
            "a.toml as set: segment[0].length = -3: must be a number from 0.001 to 100000 mm. "
            "Write a plain number, in mm\n");
  EXPECT_EQ(problems_of(read_with({"segment.0.lenght=3"})),
            "a.toml as set: segment[0].lenght = 3: is not a known key. Did you mean length?\n");
  EXPECT_EQ(problems_of(read_with({"exprt.tolerance=0.02"})),
            "a.toml as set: exprt = {...}: is not a known key. Did you mean export?\n");
  EXPECT_EQ(problems_of(read_with({"model.joint=papr"})),
            "a.toml as set: model.joint = \"papr\": must be \"none\" or \"paper\" or "
            "\"clear-span\". Did you mean paper?\n");
}

struct Nowhere {
  const char* setting;
  const char* problem;
};

class PathsThatLeadNowhere : public testing::TestWithParam<Nowhere> {};

TEST_P(PathsThatLeadNowhere, AreToldWithWhatWasMeant) {
  const ReadResult result = read_with({GetParam().setting}, named_grammar());
  ASSERT_EQ(result.issues.size(), 1U) << problems_of(result);
  EXPECT_EQ(problems_of(result),
            std::string("a.toml as set: ") + GetParam().setting + ": " + GetParam().problem + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, PathsThatLeadNowhere,
    testing::Values(
        Nowhere{"segment.tpi.length=3",
                "segment is a list, and none of its entries is named tpi. Did you mean tip?"},
        Nowhere{"segment.length=3",
                "segment is a list, and none of its entries is named length. "
                "Known names: tip"},
        Nowhere{"segment.1.lattice.grid.angle=3",
                "segment.1.lattice.grid is a list, and none of its entries is named angle. Name an "
                "entry by its number, counted from 0: segment.1.lattice.grid.0.angle"},
        Nowhere{"segment.3.length=3",
                "segment has 3 entries, and no number 3. Entries are counted from 0"},
        Nowhere{"segmnt.0.length=3", "the design has no segmnt. Did you mean segment?"},
        Nowhere{"segment.0.length.mm=3",
                "segment.0.length is 85 here, and nothing is inside it. Set it as a whole"},
        Nowhere{"segment.0.length", "is no setting. Write PATH=VALUE, as in segment.0.length=90"},
        Nowhere{"segment..length=3",
                "is no path: a step is missing, or is no key: quote what has other signs than "
                "letters, digits, _ and -. See segment.0.length"},
        Nowhere{"segment[x].length=3",
                "is no path: an entry of a list is written [0], counted from 0. See "
                "segment.0.length"},
        Nowhere{"segment.0.length=3 mm",
                "has a value that is neither one of TOML nor a word. Write a number, true, "
                "\"text\", [1, 2] or { from = 2, to = 3 }"},
        Nowhere{"segment.0.length=",
                "has a value that is neither one of TOML nor a word. Write a number, true, "
                "\"text\", [1, 2] or { from = 2, to = 3 }"}));

TEST(Settings, NameEveryProblemAtOnce) {
  const ReadResult result = read_with({"segment.9.length=3", "x", "segment.0.length=-1"});
  EXPECT_EQ(result.issues.size(), 3U) << problems_of(result);
}

TEST(Settings, ASecondKeyIsNoPartOfAValue) {
  EXPECT_EQ(read_with({"segment.0.length=85\nname=\"b\""}).issues.size(), 1U);
}

// Whatever is typed, a design or a list of problems comes of it.
TEST(Settings, TakeAnything) {
  constexpr unsigned seed = 20151;
  std::mt19937 random(seed);
  const Settings pieces = {"segment", "0",  "9", "lattice", "grid", ".", ".",  "[", "]",  "[1]",
                           "=",       "\"", "'", "{",       "}",    "a", "\n", ",", "-1", "width"};
  for (int trial = 0; trial < 3000; ++trial) {
    std::string setting;
    for (unsigned i = random() % 12; i > 0; --i) setting += pieces[random() % pieces.size()];
    const ReadResult result = read_with({setting});
    for (const Issue& issue : result.issues) {
      EXPECT_FALSE(describe(issue, "a.toml").empty()) << seed << " " << setting;
    }
  }
}

}  // namespace
}  // namespace latticast
