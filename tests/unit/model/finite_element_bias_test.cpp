// SPDX-License-Identifier: GPL-3.0-or-later
// docs/model.md#what-it-leaves-out: how far the analytic model is from a finite-element cell of the
// same lattice.
// The bias is known and stated to users; this test notices when a change of the model moves it.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "tests/golden/finite_element_cell.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

struct Bias {
  double least = 1e9;
  double most = -1e9;

  void add(double found, double reference) {
    const double percent = 100 * (found / reference - 1);
    least = std::min(least, percent);
    most = std::max(most, percent);
  }
};

void expect_bias(JointModel joint, double stretch_low, double stretch_high, double twist_low,
                 double twist_high) {
  const std::vector<CellState> cell = finite_element_cell();
  ASSERT_EQ(cell.size(), 6U);
  std::vector<double> pressures;
  for (const CellState& at : cell) pressures.push_back(at.pressure_kpa);
  Segment segment = paper_segment({36});
  segment.length_mm = 80;  // eight whole periods
  segment.lattice->rings = Rings{std::nullopt, 10.0, 2};
  const Response response = predict(segment, with_joint(joint), pressures);
  ASSERT_EQ(response.status, Status::ok);
  Bias stretch;
  Bias twist;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    stretch.add(response.states[i]->stretch - 1, cell[i].stretch - 1);
    twist.add(-response.states[i]->twist_rad_per_mm, cell[i].twist_rad_per_mm);
  }
  EXPECT_NEAR(stretch.least, stretch_low, 0.1);
  EXPECT_NEAR(stretch.most, stretch_high, 0.1);
  EXPECT_NEAR(twist.least, twist_low, 0.1);
  EXPECT_NEAR(twist.most, twist_high, 0.1);
}

TEST(FiniteElementBias, PaperJoint) {
  expect_bias(JointModel::paper, 24.0, 36.8, 12.5, 29.8);
}

TEST(FiniteElementBias, ClearSpanJoint) {
  expect_bias(JointModel::clear_span, 17.6, 28.0, 7.4, 20.2);
}

}  // namespace
}  // namespace latticast::testing
