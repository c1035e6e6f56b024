// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of the model side by side, each the same as when it is asked for alone.
#include "app/kind_comparison.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/wall_output.h"
#include "design/unsupported_design.h"
#include "model/kind_prediction.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

Design twisting(double angle_deg) {
  Design design;
  design.segments = {twisting_segment(angle_deg)};
  return design;
}

TEST(KindComparison, HasWhatEachKindSaysAlone) {
  const Design design = twisting(45);
  const std::vector<double> pressures = {10, 40};
  const KindComparison compared = compare_kinds(design, pressures, {});
  EXPECT_TRUE(compared.complete);
  ASSERT_EQ(compared.numbers.columns.size(), 11U);
  EXPECT_EQ(compared.numbers.columns[2], "layered_stretch");
  EXPECT_EQ(compared.numbers.columns[5], "bonded_stretch");
  EXPECT_EQ(compared.numbers.columns[9], "unit_cell_twist_deg");
  ASSERT_EQ(compared.numbers.rows.size(), 2U);
  for (std::size_t k = 0; k < compared_kinds.size(); ++k) {
    Design one = design;
    one.model.wall = compared_kinds[k];
    const Prediction alone = predict_design(one, pressures, {}, false);
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      const State& state = alone.segments[0].response.states[i].value();
      EXPECT_EQ(compared.numbers.rows[i][1], pressures[i]);
      EXPECT_EQ(compared.numbers.rows[i][2 + 3 * k], state.stretch);
      EXPECT_EQ(compared.numbers.rows[i][3 + 3 * k], twist_deg(state, one.segments[0]));
    }
  }
}

TEST(KindComparison, LeavesOutAKindThatDoesNotKnowTheDesignAndSaysWhy) {
  Design design = twisting(45);
  design.segments[0].lattice->grids[0].widths_mm[0] = 1.5;  // an uneven tilted family has no cell
  const KindComparison compared = compare_kinds(design, {10}, {});
  ASSERT_EQ(compared.numbers.rows.size(), 1U);
  EXPECT_EQ(compared.numbers.columns[2], "layered_stretch");
  for (const std::string& column : compared.numbers.columns) {
    EXPECT_EQ(column.find("unit_cell"), std::string::npos);
  }
  EXPECT_TRUE(
      std::any_of(compared.notes.begin(), compared.notes.end(), [](const std::string& note) {
        return note.find("unit-cell is left out: ") != std::string::npos;
      }));
}

TEST(KindComparison, SaysWhichKindHasNoStateAtAPressure) {
  // Between the limit points of the cell and of the layered section, docs/unit-cell.md.
  const KindComparison compared = compare_kinds(twisting(36), {20, 95}, {});
  EXPECT_FALSE(compared.complete);
  ASSERT_EQ(compared.numbers.rows.size(), 1U);
  ASSERT_EQ(compared.numbers.missing.size(), 1U);
  const std::string& reason = compared.numbers.missing[0].reason;
  EXPECT_NE(reason.find("unit-cell: "), std::string::npos) << reason;
  EXPECT_EQ(reason.find("layered: "), std::string::npos) << reason;
}

TEST(WallOutput, IsTheUnitCellsAndRefusedWithoutOne) {
  Design design = twisting(45);
  EXPECT_THROW(predict_walls(design, {10}), UnsupportedDesign);
  design.model.wall = WallKind::unit_cell;
  const NumberRows numbers = predict_walls(design, {10, 30});
  EXPECT_TRUE(numbers.missing.empty());
  ASSERT_EQ(numbers.rows.size(), 2U);
  for (std::size_t i = 2; i < 6; ++i) {
    EXPECT_GT(numbers.rows[1][i], numbers.rows[0][i]) << numbers.columns[i];
  }
  EXPECT_LT(numbers.rows[1][6], numbers.rows[0][6]) << "the liner is pressed against the lattice";
}

}  // namespace
}  // namespace latticast::testing
