// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed unit cell against closed forms, symmetry and a finer finite-element mesh.
#include "model/cell/unit_cell.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "numerics/root_search.h"
#include "tests/golden/fe_cell_twist.h"
#include "tests/unit/model/cell/cell_meshes.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

ModelChoice unit_cell() {
  ModelChoice model;
  model.wall = WallKind::unit_cell;
  return model;
}

constexpr std::array coordinates = {&Deformation::elongation, &Deformation::twist,
                                    &Deformation::inner_growth};

constexpr double exactly = 1e-10;

TEST(CondensedCell, HasItsDerivatives) {
  CondensedCell cell(strip_cell(strips(36), small_division), exactly);
  const Deformation at{.elongation = 0.05, .twist = -0.002, .inner_growth = 0.4};
  const SectionEnergy here = *cell.at(at);
  constexpr std::array steps = {1e-4, 1e-5, 1e-3};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    Deformation ahead = at;
    Deformation behind = at;
    ahead.*coordinates[k] += steps[k];
    behind.*coordinates[k] -= steps[k];
    const SectionEnergy a = *cell.at(ahead);
    const SectionEnergy b = *cell.at(behind);
    const double slope = (a.value - b.value) / (2 * steps[k]);
    EXPECT_NEAR(slope, here.gradient[k], 1e-5 * std::abs(here.gradient[k])) << k;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const double second = (a.gradient[i] - b.gradient[i]) / (2 * steps[k]);
      EXPECT_NEAR(second, here.second(i, k), 1e-6 * std::abs(here.second(i, k))) << i << k;
    }
  }
}

TEST(CondensedCell, FollowsItsPathInFewSteps) {
  CondensedCell cell(strip_cell(strips(36), small_division));
  ASSERT_TRUE(cell.at({}));
  const int before = cell.factorisations();
  constexpr int states = 10;  // up to 60 kPa, nearly
  for (int i = 1; i <= states; ++i) {
    const double share = double(i) / states;
    ASSERT_TRUE(cell.at(
        {.elongation = 0.35 * share, .twist = -0.023 * share, .inner_growth = 4.5 * share}));
  }
  EXPECT_LE(cell.factorisations() - before, 3 * states);
}

/// Largest relative error of the gradient, against the section of an incompressible tube.
double bare_tube_error(const Law& law, const StripDivision& division) {
  const Deformation q{.elongation = 0.2, .twist = 0.01, .inner_growth = 1.5};
  const Section section = prepare_section(tube(12, 16, law), {});
  const auto exact = stored_energy(section, make_quadrature(section, 32, 1, 1, 1), q);
  CondensedCell cell(bare_tube(12, 16, law, division, 1e7), exactly);
  for (int i = 1; i < 8; ++i) {
    const double share = i / 8.0;
    cell.at({.elongation = share * q.elongation,
             .twist = share * q.twist,
             .inner_growth = share * q.inner_growth});
  }
  const auto found = cell.at(q);
  if (!found || !exact) return HUGE_VAL;
  double error = 0;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    error = std::max(error, std::abs(found->gradient[i] / exact->gradient[i] - 1));
  }
  return error;
}

TEST(CondensedCell, OfABareTubeIsTheClosedForm) {
  for (const Law& law :
       std::vector<Law>{NeoHookean{0.08}, Yeoh{0.03, 0.002, 0.0001}, Gent{0.08, 60},
                        Mooney{0.03, 0.01}, Ogden{{0.05, -0.01}, {1.3, -3}}}) {
    EXPECT_LT(bare_tube_error(law, small_division), 2e-4) << law_name(law);
  }
}

TEST(CondensedCell, OfABareTubeConvergesWithTheFourthOrder) {
  StripDivision fine = small_division;
  fine.strip *= 2;
  fine.gap *= 2;
  fine.liner *= 2;
  const double coarse_error = bare_tube_error(NeoHookean{0.08}, small_division);
  const double fine_error = bare_tube_error(NeoHookean{0.08}, fine);
  EXPECT_GT(std::log2(coarse_error / fine_error), 3.6) << coarse_error << ' ' << fine_error;
}

StripDivision thick_wall() {
  StripDivision division = small_division;
  division.strip = 2;
  division.gap = 4;
  division.liner = 6;
  division.grading = 0.5;
  return division;
}

TEST(CondensedCell, OfAThickMooneyCylinderInPlaneStrain) {
  // R 7 to 18.625, C10 80, C01 20: displacements of the bore that [Rivlin 1948]'s solution has.
  CondensedCell cell(bare_tube(7, 18.625, Mooney{80, 20}, thick_wall(), 1e4), exactly);
  const auto pressure = [&](double growth) {
    return cell.at({.inner_growth = growth})->gradient[coordinate::inner_growth] /
           (2 * pi * (7 + growth));
  };
  double from = 0;
  for (const auto& [load, expected] : std::vector<std::pair<double, double>>{
           {50, 1.2406129}, {100, 3.2115017}, {150, 7.1818714}}) {
    double low = from;
    double high = 1.2 * expected;
    RootSearch search(low, pressure(low) - load, high, pressure(high) - load);
    double growth = high;
    for (int i = 0; i < 60 && search.width() > 1e-9; ++i) {
      growth = search.next();
      search.narrow(growth, pressure(growth) - load);
    }
    EXPECT_NEAR(growth, expected, 2e-4 * expected);
    from = expected;
  }
}

TEST(CondensedCell, OfAThickMooneyCylinderTendsToItsLimitPressure) {
  // In plane strain the pressure rises with the bore, for ever, to 2 (C10 + C01) ln(18.625/7).
  CondensedCell cell(bare_tube(7, 18.625, Mooney{80, 20}, thick_wall(), 1e4), exactly);
  double largest = 0;
  for (double growth = 1; growth < 70; growth *= 1.6) {
    const auto energy = cell.at({.inner_growth = growth});
    ASSERT_TRUE(energy) << growth;
    const double pressure = energy->gradient[coordinate::inner_growth] / (2 * pi * (7 + growth));
    EXPECT_GT(pressure, largest) << growth;
    largest = pressure;
  }
  EXPECT_NEAR(largest, 195.7, 0.003 * 195.7);
}

TEST(CondensedCell, OfAHalfIsThatOfTheWhole) {
  StripDivision whole = small_division;
  whole.whole = true;
  CondensedCell half(strip_cell(strips(36), small_division), exactly);
  CondensedCell full(strip_cell(strips(36), whole), exactly);
  const Deformation q{.elongation = 0.1, .twist = -0.005, .inner_growth = 0.8};
  const auto a = half.at(q);
  const auto b = full.at(q);
  ASSERT_TRUE(a && b);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    EXPECT_NEAR(b->gradient[i], a->gradient[i], 1e-8 * std::abs(a->gradient[i]));
    for (std::size_t j = 0; j < coordinates.size(); ++j) {
      EXPECT_NEAR(b->second(i, j), a->second(i, j), 1e-7 * std::abs(a->second(i, j)));
    }
  }
}

TEST(UnitCell, AgreesWithAFinerMesh) {
  for (const double angle : {36.0, 60.0}) {
    const std::vector<CellRow> rows = finite_element_rows(angle);
    ASSERT_EQ(rows.size(), 6U);
    std::vector<double> pressures;
    pressures.reserve(rows.size());
    for (const CellRow& row : rows) pressures.push_back(row.pressure_kpa);
    const Response response = predict(twisting_segment(angle), unit_cell(), pressures);
    ASSERT_EQ(response.status, Status::ok);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const State& state = *response.states[i];
      EXPECT_NEAR((state.stretch - 1) / (rows[i].stretch - 1), 1, 0.03) << angle << ' ' << i;
      EXPECT_NEAR(state.twist_rad_per_mm / rows[i].twist_rad_per_mm, 1, 0.03);
      EXPECT_TRUE(state.stable);
    }
  }
}

/// What pressure did along the states number 0, step, 2 step ..., by the trapezoidal rule, N.
double work_along(const std::vector<std::optional<State>>& states, std::size_t step) {
  const auto cavity = [](const State& state) {
    return pi * state.inner_radius_mm * state.inner_radius_mm * state.stretch;
  };
  double work = 0;
  for (std::size_t i = step; i < states.size(); i += step) {
    const State& from = *states[i - step];
    const State& to = *states[i];
    work += 0.5e-3 * (from.pressure_kpa + to.pressure_kpa) * (cavity(to) - cavity(from));
  }
  return work;
}

TEST(UnitCell, StoresTheWorkOfPressure) {
  constexpr int steps = 16;
  std::vector<double> pressures;
  for (int i = 0; i <= steps; ++i) pressures.push_back(60.0 * i / steps);
  const Segment segment = twisting_segment(36);
  const Response response = predict(segment, unit_cell(), pressures);
  ASSERT_EQ(response.status, Status::ok);
  UnitCellEnergy energy(*find_unit_cell(segment).cell);
  double stored = 0;
  for (const auto& state : response.states) {
    const auto here = energy.at({.elongation = state->stretch - 1,
                                 .twist = state->twist_rad_per_mm,
                                 .inner_growth = state->inner_radius_mm - 12});
    ASSERT_TRUE(here) << state->pressure_kpa;
    stored = here->energy.value;
  }
  // The rule's error is of second order in the steps, so that what is left of it is of the fourth.
  const double coarse = work_along(response.states, 2);
  const double fine = work_along(response.states, 1);
  EXPECT_NEAR((coarse - stored) / (fine - stored), 4, 0.2);
  EXPECT_NEAR((4 * fine - coarse) / 3, stored, 1e-4 * stored);
}

TEST(UnitCell, OfTheMirroredDesignTwistsTheOtherWay) {
  const std::vector<double> pressures = {20};
  const Response right = predict(twisting_segment(36), unit_cell(), pressures);
  const Response left = predict(twisting_segment(144), unit_cell(), pressures);
  ASSERT_TRUE(right.states[0] && left.states[0]);
  EXPECT_NEAR(left.states[0]->stretch, right.states[0]->stretch, 1e-9);
  EXPECT_NEAR(left.states[0]->twist_rad_per_mm, -right.states[0]->twist_rad_per_mm, 1e-10);
}

TEST(UnitCell, HoldsCoordinatesAndGivesTheirReactions) {
  const Response blocked =
      predict(twisting_segment(36), unit_cell(), std::vector<double>{20}, Held{.twist = true});
  ASSERT_TRUE(blocked.states[0]);
  EXPECT_EQ(blocked.states[0]->twist_rad_per_mm, 0);
  EXPECT_GT(std::abs(blocked.states[0]->torque_nmm), 50);
  EXPECT_EQ(blocked.states[0]->force_n, 0);
}

TEST(UnitCell, EndsNearItsLimitPoint) {
  const Response response = predict(twisting_segment(36), unit_cell(), std::vector<double>{60, 95});
  ASSERT_TRUE(response.states[0]);
  EXPECT_FALSE(response.states[1]);
  ASSERT_EQ(response.critical_points.size(), 1U);
  EXPECT_EQ(response.critical_points[0].kind, CriticalKind::limit_point);
  // The section without a cell says 108.8 kPa.
  EXPECT_NEAR(response.critical_points[0].pressure_kpa, 80, 2);
}

/// Strips on a liner of hardly any thickness, without rings.
struct ThinTube {
  double angle_deg = 90;
  double stiffness = 1;  ///< of the strips, E over the liner's mu
};

std::ostream& operator<<(std::ostream& out, const ThinTube& tube) {
  return out << tube.angle_deg << " degrees, E/mu " << tube.stiffness;
}

class UnderSuction : public ::testing::TestWithParam<ThinTube> {};

TEST_P(UnderSuction, HoldsWellOrSaysWhyNot) {
  Segment segment = paper_segment({GetParam().angle_deg});
  segment.liner.thickness_mm = 0.2;
  segment.lattice->rings.reset();
  segment.lattice->material.law = Linear{GetParam().stiffness * 0.08, 0.49};
  const Response response = predict(segment, unit_cell(), std::vector<double>{-40});
  if (!response.states[0]) {
    EXPECT_NE(response.status, Status::ok);
    EXPECT_FALSE(response.message.empty());
    return;
  }
  const State& state = *response.states[0];
  EXPECT_TRUE(state.stable);
  EXPECT_TRUE(std::isfinite(state.stretch + state.twist_rad_per_mm + state.inner_radius_mm));
  EXPECT_LT(state.error_estimate, 0.1);
}

// Not 20 degrees with 1e6: there the coarse mesh is more than twice as stiff as the fine one, so
// that the energy extrapolated from both has no minimum, not even at rest.
INSTANTIATE_TEST_SUITE_P(UnitCell, UnderSuction,
                         ::testing::Values(ThinTube{90, 1}, ThinTube{90, 1e6}, ThinTube{20, 1}));

TEST(UnitCell, IsRefinedAsFarAsItsErrorAsks) {
  const Segment segment = twisting_segment(36);
  const FoundCell usual = find_unit_cell(segment);
  const double first = rest_error_percent(*usual.cell);
  EXPECT_EQ(find_unit_cell(segment, 1.01 * first).cell->fine.unknowns, usual.cell->fine.unknowns);
  const FoundCell finer = find_unit_cell(segment, 0.99 * first);
  ASSERT_TRUE(finer.cell) << finer.reason;
  EXPECT_GT(finer.cell->fine.unknowns, 2 * usual.cell->fine.unknowns);
  const double second = rest_error_percent(*finer.cell);
  EXPECT_LT(second, first);
  const FoundCell none = find_unit_cell(segment, 0.05);
  EXPECT_FALSE(none.cell);
  EXPECT_NE(none.reason.find("within"), std::string::npos) << none.reason;
}

TEST(UnitCell, IsAsNearToItsLimitAsItsErrorSays) {
  // d(lambda, k R_o, a/R_i)/dP at rest, 1/MPa, of meshes up to 28 834 unknowns and their order
  // (docs/unit-cell.md#extrapolation).
  struct Limit {
    double angle_deg;
    std::array<double, 3> response;
  };
  for (const Limit& limit :
       {Limit{36, {3.798, -4.151, 4.280}}, Limit{60, {2.501, -4.475, 4.275}}}) {
    const Segment segment = twisting_segment(limit.angle_deg);
    const double error = 0.01 * rest_error_percent(*find_unit_cell(segment).cell);
    const std::vector<double> pressures = {0.01};
    const State state = predict(segment, unit_cell(), pressures).states.front().value();
    const std::array<double, 3> found = {(state.stretch - 1) / 1e-5,
                                         18 * state.twist_rad_per_mm / 1e-5,
                                         (state.inner_radius_mm / 12 - 1) / 1e-5};
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], limit.response[i], error * std::abs(limit.response[i])) << i;
    }
  }
}

}  // namespace
}  // namespace latticast::testing
