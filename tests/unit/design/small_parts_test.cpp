// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps, graded widths, nearest names, and how an issue is described.
#include <limits>

#include <gtest/gtest.h>

#include "design/grid_widths.h"
#include "design/issue.h"
#include "design/nearest_name.h"
#include "design/pressure_sweep.h"
#include "design/text/printable.h"

namespace latticast {
namespace {

TEST(PressureSweep, ReachesItsEndInSpiteOfRounding) {
  const std::vector<double> tenths = sweep_pressures_kpa({0, 1, 0.1});
  ASSERT_EQ(tenths.size(), 11U);
  EXPECT_EQ(tenths.back(), 1.0);
  EXPECT_EQ(sweep_pressures_kpa({0, 0.3, 0.1}).back(), 0.3);
}

TEST(PressureSweep, StopsBeforeAnEndThatItMisses) {
  EXPECT_EQ(sweep_pressures_kpa({0, 60, 25}), (std::vector<double>{0, 25, 50}));
  EXPECT_EQ(sweep_pressures_kpa({0, 10, 100}), std::vector<double>{0});
  EXPECT_EQ(sweep_pressures_kpa({5, 5, -1}), std::vector<double>{5});
}

TEST(PressureSweep, SizesThatNobodyMayAllocate) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sweep_size({0, 60, 0}), 0);
  EXPECT_EQ(sweep_size({0, 60, -5}), 0);
  EXPECT_EQ(sweep_size({0, infinite, 5}), 0);
  EXPECT_EQ(sweep_size({0, 60, infinite}), 0);
  EXPECT_EQ(sweep_size({0, std::numeric_limits<double>::quiet_NaN(), 5}), 0);
  EXPECT_NEAR(sweep_size({0, 1e5, 1e-7}), 1e12, 2);
  EXPECT_EQ(sweep_size({0, 60, 1e-320}), infinite);
}

TEST(GradedWidths, CosineIsFromAtStrandZeroAndToOppositeIt) {
  const std::vector<double> widths = graded_widths_mm(2, 4, WidthProfile::cosine, 8);
  ASSERT_EQ(widths.size(), 8U);
  EXPECT_EQ(widths[0], 2);
  EXPECT_NEAR(widths[2], 3, 1e-15);
  EXPECT_NEAR(widths[4], 4, 1e-15);
  for (int j = 1; j < 8; ++j) EXPECT_NEAR(widths[j], widths[8 - j], 1e-15) << j;
}

TEST(GradedWidths, FewStrands) {
  for (const WidthProfile profile : {WidthProfile::cosine, WidthProfile::halves}) {
    EXPECT_TRUE(graded_widths_mm(2, 4, profile, 0).empty());
    EXPECT_EQ(graded_widths_mm(2, 4, profile, 1), std::vector<double>{2});
    EXPECT_EQ(graded_widths_mm(2, 4, profile, 2), (std::vector<double>{2, 4}));
  }
}

TEST(Printable, EscapesWhatWouldMoveATerminalOrHide) {
  EXPECT_EQ(printable("plain \u00e9\u4e2d\U0001F600 text"), "plain \u00e9\u4e2d\U0001F600 text");
  EXPECT_EQ(printable("a\x1b[2Jb\n"), "a\\u001b[2Jb\\u000a");
  EXPECT_EQ(printable("a\nb\x1b", "\n"), "a\nb\\u001b");
  EXPECT_EQ(printable("\x7f\u0085"), "\\u007f\\u0085");
  EXPECT_EQ(printable("a\u202Etxt.exe\u2066b\uFEFF\u200B"),
            "a\\u202etxt.exe\\u2066b\\ufeff\\u200b");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
  // Half a character, and bytes that begin none.
  EXPECT_EQ(printable("a\xE2\x80"), "a\xE2\x80");
  EXPECT_EQ(printable("\xC2"), "\xC2");
  EXPECT_EQ(printable("\xFF\x9F"), "\xFF\x9F");
}

TEST(Printable, TellsControlFromHidden) {
  EXPECT_EQ(first_unprintable("tube-36 \u00e4"), Unprintable::none);
  EXPECT_EQ(first_unprintable("a\tb"), Unprintable::control);
  EXPECT_EQ(first_unprintable("a\u0090b"), Unprintable::control);
  EXPECT_EQ(first_unprintable("a\u2069b\n"), Unprintable::hidden);
}

TEST(EditDistance, KnownValues) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);
  EXPECT_EQ(edit_distance("Length", "length"), 0);
  EXPECT_EQ(edit_distance("ca", "abc"), 3);  // the restricted distance, not 2
}

TEST(NearestNames, OnlyWhatIsNear) {
  const std::vector<std::string> known = {"count", "pitch", "width", "E", "mu"};
  EXPECT_EQ(nearest_names("cuont", known), std::vector<std::string>{"count"});
  EXPECT_EQ(nearest_names("wid", known), std::vector<std::string>{"width"});
  EXPECT_TRUE(nearest_names("colour_of_the_thing", known).empty());
  EXPECT_TRUE(nearest_names("x", known).empty());
  EXPECT_TRUE(nearest_names("", known).empty());
  EXPECT_TRUE(nearest_names(std::string(4000000, 'c'), known).empty());
}

TEST(NameHint, ListsWhatThereIsWhenNothingIsNear) {
  EXPECT_EQ(name_hint("cuont", {"count", "pitch"}, "keys"), "did you mean count?");
  EXPECT_EQ(name_hint("zzzzzz", {"count", "pitch"}, "keys"), "known keys: count, pitch");
  EXPECT_EQ(name_hint("a", {}, "materials"), "there are no materials here");
}

TEST(Describe, LeavesOutWhatIsNotThere) {
  EXPECT_EQ(describe({4, "make.liner", "3", "must be true or false", "write true"}, "a.toml"),
            "a.toml:4: make.liner = 3: must be true or false. Write true");
  EXPECT_EQ(describe({0, "name", "", "must be given", ""}, "a.toml"),
            "a.toml: name: must be given");
  EXPECT_EQ(describe({2, "", "", "must be TOML", "mend it"}, "a.toml"),
            "a.toml:2: must be TOML. Mend it");
}

}  // namespace
}  // namespace latticast
