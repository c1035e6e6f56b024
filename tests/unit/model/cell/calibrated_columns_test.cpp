// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of columns, calibrated by the cell that is drawn.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "design/unsupported_design.h"
#include "model/cell/unit_cell.h"
#include "model/prepared_segment.h"
#include "model/section/section_energy.h"
#include "model/segment_response.h"
#include "tests/unit/model/cell/waves.h"

namespace latticast::testing {
namespace {

ModelChoice calibrated(Calibrate what) {
  ModelChoice model;
  model.wall = WallKind::bonded;
  model.calibrate = what;
  return model;
}

/// A slim tube with six columns, the first three of them thick.
Segment slim() {
  Segment segment = waves(halves(6, 2.5, 2), 0.25);
  segment.liner.inner_radius_mm = 3;
  segment.liner.thickness_mm = 2.5;
  return segment;
}

State state_at(const Segment& segment, const ModelChoice& model, double pressure_kpa) {
  const std::vector<double> pressures = {pressure_kpa};
  const Response response = predict(segment, model, pressures);
  EXPECT_EQ(response.status, Status::ok) << response.message;
  return response.states.front().value();
}

TEST(CalibratedColumns, HaveTheCellsStiffness) {
  const Segment segment = slim();
  const PreparedSegment prepared = prepare_segment(segment, calibrated(Calibrate::stiffness));
  const auto& section = std::get<Section>(prepared.section);
  EXPECT_FALSE(section.twists);
  EXPECT_EQ(section.bending_axes, 2);
  const SectionEnergy own =
      stored_energy(section, make_quadrature(section, 16, 16, 32), {}).value();
  const SectionEnergy cell = UnitCellEnergy(*prepared.cell).at({}).value().energy;
  const std::vector<int> free = {coordinate::elongation, coordinate::inner_growth,
                                 coordinate::bend_1, coordinate::bend_2};
  for (const int i : free) {
    for (const int j : free) {
      const double size = std::sqrt(cell.second(i, i) * cell.second(j, j));
      EXPECT_NEAR(own.second(i, j), cell.second(i, j), 1e-9 * size) << i << ' ' << j;
    }
  }
  // The uneven columns bend the tube as soon as it lengthens.
  EXPECT_GT(std::hypot(own.second(coordinate::elongation, coordinate::bend_1),
                       own.second(coordinate::elongation, coordinate::bend_2)),
            1e-3 * std::sqrt(own.second(0, 0) * own.second(3, 3)));
}

TEST(CalibratedColumns, HaveExactDerivatives) {
  const PreparedSegment prepared = prepare_segment(slim(), calibrated(Calibrate::stiffness));
  const auto& section = std::get<Section>(prepared.section);
  const Quadrature quadrature = make_quadrature(section, 6, 4, 12);
  const std::array<double, 5> q = {0.06, 0.002, 0.3, 0.003, -0.002};
  const std::array<double, 5> step = {2e-4, 1e-5, 1e-3, 1e-5, 1e-5};
  const auto energy = [&](std::size_t i, double h) {
    std::array<double, 5> p = q;
    p[i] += h;
    return stored_energy(section, quadrature, {p[0], p[1], p[2], p[3], p[4]}).value();
  };
  const SectionEnergy exact = energy(0, 0);
  for (std::size_t i = 0; i < 5; ++i) {
    const double h = step[i];
    const auto slope = [&](auto&& of) {
      return (45 * (of(energy(i, h)) - of(energy(i, -h))) -
              9 * (of(energy(i, 2 * h)) - of(energy(i, -2 * h))) +
              (of(energy(i, 3 * h)) - of(energy(i, -3 * h)))) /
             (60 * h);
    };
    const double scale = std::sqrt(exact.value * std::abs(exact.second(i, i)));
    EXPECT_NEAR(exact.gradient[i], slope([](const SectionEnergy& e) { return e.value; }),
                1e-7 * scale);
    for (std::size_t j = 0; j < 5; ++j) {
      const double size = std::sqrt(std::abs(exact.second(i, i) * exact.second(j, j)));
      EXPECT_NEAR(exact.second(i, j), slope([&](const SectionEnergy& e) { return e.gradient[j]; }),
                  1e-6 * size);
    }
  }
}

TEST(CalibratedColumns, BendAsTheCellDoes) {
  const State cell = state_at(slim(), unit_cell(), 40);
  const State rest = state_at(slim(), calibrated(Calibrate::stiffness), 40);
  const State both = state_at(slim(), calibrated(Calibrate::state), 40);
  ASSERT_GT(cell.bend_magnitude_rad_per_mm(), 1e-4);
  EXPECT_NEAR(rest.stretch - 1, cell.stretch - 1, 0.05 * (cell.stretch - 1));
  EXPECT_NEAR(rest.bend_magnitude_rad_per_mm(), cell.bend_magnitude_rad_per_mm(),
              0.06 * cell.bend_magnitude_rad_per_mm());
  EXPECT_NEAR(both.stretch - 1, cell.stretch - 1, 1e-3 * (cell.stretch - 1));
  EXPECT_NEAR(both.bend_magnitude_rad_per_mm(), cell.bend_magnitude_rad_per_mm(),
              1e-3 * cell.bend_magnitude_rad_per_mm());
  EXPECT_NEAR(both.bend_direction_rad(), cell.bend_direction_rad(), 1e-3);
}

TEST(CalibratedColumns, TwistWhereTheirRingsMakeThem) {
  const Segment segment = elongating(0.5);
  for (const double pressure : {15.0, 30.0}) {
    const State cell = state_at(segment, unit_cell(), pressure);
    const State rest = state_at(segment, calibrated(Calibrate::stiffness), pressure);
    EXPECT_NEAR(rest.stretch - 1, cell.stretch - 1, 0.03 * (cell.stretch - 1));
    EXPECT_NEAR(rest.twist_rad_per_mm, cell.twist_rad_per_mm,
                0.08 * std::abs(cell.twist_rad_per_mm));
  }
  const std::vector<double> pressures = {15, 30};
  const Response both = predict(segment, calibrated(Calibrate::state), pressures);
  const Response cell = predict(segment, unit_cell(), pressures);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const double expected = cell.states[i]->twist_rad_per_mm;
    EXPECT_NEAR(both.states[i]->twist_rad_per_mm, expected, 0.01 * std::abs(expected));
  }
  EXPECT_NE(both.message.find("% in twist"), std::string::npos) << both.message;
}

TEST(CalibratedColumns, AreRefusedWithoutACell) {
  const auto reason = [](const Segment& segment, Calibrate what) -> std::string {
    try {
      prepare_segment(segment, calibrated(what));
    } catch (const UnsupportedDesign& problem) {
      return problem.what();
    }
    return {};
  };
  EXPECT_NE(reason(elongating(0.25), Calibrate::nothing).find("by calibration alone"),
            std::string::npos);
  Segment leaning = elongating(0.25);
  leaning.lattice->grids[0] = {80, halves(16, 2.2, 2),
                               Horseshoe{85.0 / 32 / 0.984807753, 180, true}};
  EXPECT_NE(reason(leaning, Calibrate::stiffness).find("unit cell"), std::string::npos);
}

}  // namespace
}  // namespace latticast::testing
