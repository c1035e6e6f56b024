// SPDX-License-Identifier: GPL-3.0-or-later
// MODEL.md section 9: how far the analytic model is from a finite-element cell of the same lattice.
// The bias is known and stated to users; this test notices when a change of the model moves it.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "model/response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

struct Reference {
  std::vector<double> pressure_kpa;
  std::vector<double> elongation;
  std::vector<double> twist;
};

Reference read_reference() {
  std::ifstream file(LATTICAST_SOURCE_DIR "/tests/golden/fe_alpha36.csv");
  Reference reference;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    double pressure = 0;
    double stretch = 0;
    double twist = 0;
    char comma = 0;
    fields >> pressure >> comma >> stretch >> comma >> twist;
    reference.pressure_kpa.push_back(pressure);
    reference.elongation.push_back(stretch - 1);
    reference.twist.push_back(twist);
  }
  return reference;
}

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
  const Reference reference = read_reference();
  ASSERT_EQ(reference.pressure_kpa.size(), 6U);
  Segment segment = paper_segment({36});
  segment.length_mm = 80;  // eight whole periods
  segment.lattice->rings = Rings{std::nullopt, 10.0, 2};
  const Response response = predict(segment, with_joint(joint), reference.pressure_kpa);
  ASSERT_EQ(response.status, Status::ok);
  Bias stretch;
  Bias twist;
  for (std::size_t i = 0; i < reference.pressure_kpa.size(); ++i) {
    stretch.add(response.states[i]->stretch - 1, reference.elongation[i]);
    twist.add(-response.states[i]->twist_rad_per_mm, reference.twist[i]);
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
