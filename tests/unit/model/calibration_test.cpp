// SPDX-License-Identifier: GPL-3.0-or-later
// The bonded section: its energy against the same written out in matrices, and calibrated by the
// unit cell against the cell and a finer mesh (docs/bonded.md).
#include "model/section/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "design/unsupported_design.h"
#include "model/cell/unit_cell.h"
#include "model/numerics/gauss.h"
#include "model/section/bonded_lattice.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/golden/fe_cell_twist.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

ModelChoice bonded(Calibrate calibrate) {
  ModelChoice model;
  model.wall = WallKind::bonded;
  model.calibrate = calibrate;
  return model;
}

ModelChoice unit_cell() {
  ModelChoice model;
  model.wall = WallKind::unit_cell;
  return model;
}

Section bonded_section(const Segment& segment) {
  return prepare_section(segment, bonded(Calibrate::nothing));
}

using Vector = std::array<double, 2>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1];
}

/// F by (theta, z).
Vector mapped(const WallStrains& at, double stretch, double twist, const Vector& v) {
  const double hoop = 1 + at.hoop;
  return {hoop * v[0] + twist * at.radius_mm * hoop * v[1], stretch * v[1]};
}

TEST(BondedLattice, StripsBetweenRingsSeeTheFreeSpansStrain) {
  StrandFamily family;
  family.cosine = 0.8;
  family.sine = 0.6;
  const WallStrains at{17, 0.15, 0.22, -0.006};
  const double share = 0.2;
  const double stretch = (1 + at.elongation - share / std::sqrt(1 + at.hoop)) / (1 - share);
  const Vector strand = {family.cosine, family.sine};
  const Vector to = mapped(at, stretch, at.twist / (1 - share), strand);
  const double strain = std::sqrt(dot(to, to)) - 1;
  const double turn = std::atan2(strand[0] * to[1] - strand[1] * to[0], dot(strand, to));
  EXPECT_NEAR(bonded_strand_energy(family, 3, 0.7, share, at).value,
              0.8 * 1.5 * strain * strain + 0.35 * turn * turn, 1e-14);
}

TEST(BondedLattice, PadsFollowTheirStripAndRing) {
  StrandFamily family;
  family.cosine = -0.6;
  family.sine = 0.8;
  const WallStrains at{16, 0.1, 0.3, 0.004};
  const Vector strand = mapped(at, 1 + at.elongation, at.twist, {family.cosine, family.sine});
  const Vector across = mapped(at, 1 + at.elongation, at.twist, {-family.sine, family.cosine});
  const double length = std::sqrt(dot(strand, strand));
  const Vector along_unit = {strand[0] / length, strand[1] / length};
  const Vector across_unit = {-along_unit[1], along_unit[0]};
  const double slip = dot(across, along_unit);
  const double gap = dot(across, across_unit) - 1;
  EXPECT_NEAR(strip_pad_energy(family, 0.5, at).value, 0.25 * (slip * slip + 2 * gap * gap), 1e-14);
  const double shear = at.twist * 16 * 1.1;
  EXPECT_NEAR(ring_pad_energy(0.5, at).value, 0.25 * (shear * shear + 2 * 0.3 * 0.3), 1e-14);
}

TEST(BondedLattice, APadIsNoThickerThanASheetAllows) {
  // Half covered: (d/pi) ln sec(pi/4) = d ln(2)/(2 pi).
  EXPECT_NEAR(pad_thickness_mm(10, 0.5, 100), 10 * std::numbers::ln2 / (2 * pi), 1e-13);
  EXPECT_DOUBLE_EQ(pad_thickness_mm(10, 0.5, 0.1), 0.1);
  EXPECT_NEAR(pad_thickness_mm(10, 0.01, 100), 10 * pi * 0.01 * 0.01 / 8, 1e-6);
}

TEST(BondedLattice, APadIsWhatItsStripsTractionsDo) {
  // Rigid lines on a half-space under antiplane shear g: with p = pi x/d and s = sin(pi c/2) the
  // traction under a line is mu g sin p/sqrt(s^2 - sin^2 p), and its work on the displacement g x
  // that it holds back is the energy. sin p = s sin f makes the integrand smooth.
  const double period = 7;
  for (const double covered : {0.1, 0.5, 0.9}) {
    const double s = std::sin(0.5 * pi * covered);
    const GaussRule rule = gauss_legendre(40);
    double work = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double sine = s * std::sin(0.25 * pi * (1 + rule.points[i]));
      const double place = period / pi * std::asin(sine);
      work += 0.25 * pi * rule.weights[i] * 2 / pi * place * sine / std::sqrt(1 - sine * sine);
    }
    EXPECT_NEAR(pad_thickness_mm(period, covered, 1e3), work, 1e-9 * work) << covered;
  }
}

TEST(BondedLattice, ASlenderClearSpanOnlyBends) {
  // 12 E I/L_c over w h L_t; as long as wide it shears as well.
  const Linear material{100, 0.25};
  EXPECT_NEAR(clear_shear_joint_mpa(material, 0.01, 0.5, 11, 1), 100 * 1e-4 / (20 * 22), 1e-10);
  EXPECT_NEAR(clear_shear_joint_mpa(material, 20, 0.5, 11, 1), 100 * 400 / (20. * 22) / 4, 1e-12);
  EXPECT_EQ(clear_shear_joint_mpa(material, 2, 0.5, 0, 0), 0);
}

/// Central differences of 6th order.
template <class F>
double slope(const F& f, double h) {
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

Section calibrated_section(const Segment& segment, Calibrate calibrate) {
  return std::get<Section>(prepare_segment(segment, bonded(calibrate)).section);
}

void expect_derivatives(const Section& section, const std::array<double, 5>& q) {
  const Quadrature quadrature = make_quadrature(section, 6, 4, 12);
  const std::array<double, 5> step = {2e-4, 1e-5, 2e-3, 1e-5, 1e-5};
  const auto energy = [&](int i, double h) {
    std::array<double, 5> p = q;
    p[i] += h;
    return stored_energy(section, quadrature, {p[0], p[1], p[2], p[3], p[4]}).value();
  };
  const SectionEnergy exact = energy(0, 0);
  for (int i = 0; i < 5; ++i) {
    const double scale = std::sqrt(exact.value * std::abs(exact.second(i, i)));
    EXPECT_NEAR(exact.gradient[i], slope([&](double h) { return energy(i, h).value; }, step[i]),
                1e-7 * scale);
    for (int j = 0; j < 5; ++j) {
      const double size = std::sqrt(std::abs(exact.second(i, i) * exact.second(j, j)));
      EXPECT_NEAR(exact.second(i, j),
                  slope([&](double h) { return energy(i, h).gradient[j]; }, step[i]), 1e-6 * size);
    }
  }
}

TEST(BondedSection, DerivativesAgreeWithDifferences) {
  Segment uneven = twisting_segment(50);
  uneven.lattice->grids[0].widths_mm = halves(8, 3, 1);
  expect_derivatives(bonded_section(uneven), {0.15, 0.004, 1.2, 0.003, -0.002});
  expect_derivatives(calibrated_section(twisting_segment(36), Calibrate::stiffness),
                     {0.2, -0.006, 1.5, 0, 0});
}

TEST(BondedSection, RestsExactly) {
  const Section section = calibrated_section(twisting_segment(36), Calibrate::stiffness);
  const SectionEnergy rest = stored_energy(section, make_quadrature(section, 8, 8), {}).value();
  EXPECT_EQ(rest.value, 0);
  for (const double slope_at_rest : rest.gradient) EXPECT_EQ(slope_at_rest, 0);
}

TEST(BondedSection, RefusesCurvedStrands) {
  EXPECT_THROW(bonded_section(columns(std::vector<double>(16, 2.0))), UnsupportedDesign);
}

struct Deviations {
  Deviation stretch;
  Deviation twist;
};

Deviations from_finer_mesh(const ModelChoice& model) {
  Deviations all;
  for (const double angle : {36.0, 60.0}) {
    const std::vector<CellRow> rows = finite_element_rows(angle);
    std::vector<double> pressures;
    for (const CellRow& row : rows) pressures.push_back(row.pressure_kpa);
    const Response response = predict(twisting_segment(angle), model, pressures);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const State& state = response.states[i].value();
      all.stretch.add(state.stretch - 1, rows[i].stretch - 1);
      all.twist.add(state.twist_rad_per_mm, rows[i].twist_rad_per_mm);
    }
  }
  return all;
}

TEST(BondedSection, IsNearerToAFinerMeshThanLinesAre) {
  const Deviations found = from_finer_mesh(bonded(Calibrate::nothing));
  EXPECT_LT(found.stretch.mean(), 8.5);
  EXPECT_LT(found.stretch.worst, 15);
  EXPECT_LT(found.twist.mean(), 5);
  EXPECT_LT(found.twist.worst, 8);
}

TEST(CalibratedSection, AgreesWithAFinerMesh) {
  const Deviations rest = from_finer_mesh(bonded(Calibrate::stiffness));
  EXPECT_LT(rest.stretch.mean(), 2.5);
  EXPECT_LT(rest.stretch.worst, 7);
  EXPECT_LT(rest.twist.mean(), 1.5);
  EXPECT_LT(rest.twist.worst, 4);
  const Deviations state = from_finer_mesh(bonded(Calibrate::state));
  EXPECT_LT(state.stretch.mean(), 1);
  EXPECT_LT(state.twist.mean(), 1);
  EXPECT_LT(state.twist.worst, 2);
}

TEST(CalibratedSection, HasTheCellsStiffnessAtRest) {
  const Segment segment = twisting_segment(45);
  const Section section = calibrated_section(segment, Calibrate::stiffness);
  const SectionEnergy found = stored_energy(section, make_quadrature(section, 16, 16), {}).value();
  const SectionEnergy cell = UnitCellEnergy(*find_unit_cell(segment).cell).at({}).value().energy;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double size = std::sqrt(cell.second(i, i) * cell.second(j, j));
      EXPECT_NEAR(found.second(i, j), cell.second(i, j), 1e-11 * size) << i << j;
    }
  }
}

TEST(CalibratedSection, PassesThroughTheCellsState) {
  const std::vector<double> pressures = {40};
  for (const Held held : {Held{}, Held{.twist = true}}) {
    const State section =
        predict(twisting_segment(36), bonded(Calibrate::state), pressures, held).states[0].value();
    const State cell =
        predict(twisting_segment(36), unit_cell(), pressures, held).states[0].value();
    EXPECT_NEAR(section.stretch, cell.stretch, 2e-6);
    EXPECT_NEAR(section.inner_radius_mm, cell.inner_radius_mm, 2e-5);
    EXPECT_NEAR(section.twist_rad_per_mm, cell.twist_rad_per_mm, 2e-7);
    EXPECT_NEAR(section.torque_nmm, cell.torque_nmm, 1e-4 * std::abs(cell.torque_nmm));
  }
}

TEST(CalibratedSection, OfTheMirroredDesignTwistsTheOtherWay) {
  const std::vector<double> pressures = {20};
  const auto state = [&](double angle) {
    return predict(twisting_segment(angle), bonded(Calibrate::stiffness), pressures)
        .states[0]
        .value();
  };
  EXPECT_NEAR(state(144).stretch, state(36).stretch, 1e-9);
  EXPECT_NEAR(state(144).twist_rad_per_mm, -state(36).twist_rad_per_mm, 1e-10);
}

TEST(CalibratedSection, LeavesLimitsToTheCell) {
  const std::vector<double> pressures = {20, 95};
  const Response found = predict(twisting_segment(36), bonded(Calibrate::stiffness), pressures);
  const Response cell = predict(twisting_segment(36), unit_cell(), pressures);
  EXPECT_EQ(found.status, Status::no_equilibrium);
  EXPECT_TRUE(found.states[0]);
  EXPECT_FALSE(found.states[1]);
  ASSERT_EQ(found.critical_points.size(), 1U);
  ASSERT_EQ(cell.critical_points.size(), 1U);
  EXPECT_NEAR(found.critical_points[0].pressure_kpa, cell.critical_points[0].pressure_kpa, 0.05);
  EXPECT_NE(found.message.find("unit cell's"), std::string::npos);
}

TEST(CalibratedSection, SaysWhereItMayNotCarryFar) {
  const std::vector<double> pressures = {1};
  const auto message = [&](const Segment& segment) {
    return predict(segment, bonded(Calibrate::stiffness), pressures).message;
  };
  EXPECT_EQ(message(twisting_segment(36)), "");
  Segment thin = twisting_segment(36);
  thin.liner.thickness_mm = 1;
  EXPECT_NE(message(thin).find("a liner thinner than 0.3"), std::string::npos);
  Segment stiff = twisting_segment(36);
  stiff.lattice->material.law = Linear{5000, 0.49};
  EXPECT_NE(message(stiff).find("not 20 to 7000 times"), std::string::npos);
}

TEST(CalibratedSection, SaysWhyItIsNot) {
  const std::vector<double> pressures = {10};
  const Response pair = predict(paper_segment({36, 144}), bonded(Calibrate::stiffness), pressures);
  EXPECT_TRUE(pair.states[0]);
  EXPECT_NE(pair.message.find("not calibrated: the unit cell needs rings and families that repeat"),
            std::string::npos);
  Segment single = twisting_segment(36);
  single.lattice->grids[0].widths_mm = {2};
  const Response bent = predict(single, bonded(Calibrate::stiffness), pressures);
  EXPECT_NE(bent.message.find("differ around the tube along the axis only"), std::string::npos);
  Segment turning = twisting_segment(4);
  turning.lattice->grids[0].angle_deg = 4.4;
  turning.lattice->grids[0].widths_mm = {2, 2};
  const Response flat = predict(turning, bonded(Calibrate::stiffness), pressures);
  EXPECT_NE(flat.message.find("too flat"), std::string::npos);
}

}  // namespace
}  // namespace latticast::testing
