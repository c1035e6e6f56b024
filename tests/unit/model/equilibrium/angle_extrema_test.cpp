// SPDX-License-Identifier: GPL-3.0-or-later
// Where bending or twist turn back with pressure, and where a bending path ends.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/section/section_energy.h"
#include "model/segment_response.h"
#include "tests/unit/model/linear_check.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

Segment fitted(double thin, double thick) {
  Segment segment = columns(halves(16, thick, thin), 90, {3.5, 170, true});
  segment.liner.material.law = Linear{0.082, 0.5};
  return segment;
}

double angle_of(const State& state, AngleKind quantity) {
  return quantity == AngleKind::bend ? state.bend_magnitude_rad_per_mm()
                                     : std::abs(state.twist_rad_per_mm);
}

/// Slope of an angle by pressure over angle by pressure, from six states predicted one by one under
/// a fixed fine quadrature: about 0 at a turning point, about 1 where nothing turns.
double relative_slope(const PreparedSegment& segment, const AngleExtremum& turning) {
  SolverOptions fine;
  fine.fixed_quadrature = 40;
  const double h = 1e-3 * turning.pressure_kpa;
  const auto angle = [&](int i) {
    const std::vector<double> pressure = {turning.pressure_kpa + i * h};
    return angle_of(predict(segment, pressure, {}, fine).states[0].value(), turning.quantity);
  };
  const double slope =
      (45 * (angle(1) - angle(-1)) - 9 * (angle(2) - angle(-2)) + (angle(3) - angle(-3))) /
      (60 * h);
  return slope * turning.pressure_kpa / angle(0);
}

TEST(TurningPoints, FittedRodsBendMostNear250) {
  ModelChoice rods;
  rods.columns = ColumnModel::rods;
  const PreparedSegment segment = prepare_segment(fitted(2, 4), rods);
  const auto response = predict(segment, std::vector<double>{100, 400});
  ASSERT_EQ(response.angle_extrema.size(), 1U);
  const AngleExtremum& turning = response.angle_extrema[0];
  EXPECT_NEAR(turning.pressure_kpa, 250, 5);
  EXPECT_NEAR(bend_deg(turning.state), 50.3, 0.05);
  EXPECT_NE(turning.name.find("two branches"), std::string::npos);
  EXPECT_TRUE(turning.largest);
  EXPECT_LT(std::abs(relative_slope(segment, turning)), 1e-7);
}

TEST(TurningPoints, DistributedColumnsBendMostAt94) {
  const PreparedSegment segment = prepare_segment(columns(halves(16, 4, 2)), {});
  const auto response = predict(segment, std::vector<double>{100});
  ASSERT_EQ(response.angle_extrema.size(), 1U) << response.message;
  EXPECT_EQ(response.angle_extrema[0].quantity, AngleKind::bend);
  EXPECT_TRUE(response.angle_extrema[0].largest);
  EXPECT_LT(std::abs(relative_slope(segment, response.angle_extrema[0])), 1e-7);
}

/// Stretch instead of pressure is prescribed: pressure, bore and bending follow, by Newton's method
/// under a fine quadrature. A limit point would be a maximum of the pressure.
TEST(TurningPoints, PressureRisesWithStretchInDistributedColumns) {
  const PreparedSegment prepared = prepare_segment(columns(halves(16, 4, 2)), {});
  const Section& section = std::get<Section>(prepared.section);
  const Quadrature quadrature = make_quadrature(section, 16, 12, 48);
  double bore = 0;
  double bend = 0;
  double pressure = 0;
  double before = 0;
  double most_bend = 0;
  double at_most = 0;
  double stretch = 1;
  for (; before < 0.15; stretch += 0.002) {
    for (int iteration = 0; iteration < 12; ++iteration) {
      const Deformation q{stretch + 0.002 - 1, 0, bore, bend, 0};
      const auto energy = stored_energy(section, quadrature, q);
      if (!energy) break;
      const SectionEnergy cavity = cavity_growth(section, q);
      constexpr std::array<int, 3> rows = {coordinate::elongation, coordinate::inner_growth,
                                           coordinate::bend_1};
      FullMatrix matrix;
      FullVector right;
      for (const int i : rows) {
        right.push_back(-(energy->gradient[i] - pressure * cavity.gradient[i]));
        matrix.push_back({energy->second(i, 2) - pressure * cavity.second(i, 2),
                          energy->second(i, 3) - pressure * cavity.second(i, 3),
                          -cavity.gradient[i]});
      }
      const FullVector step = solve_linear(matrix, right);
      bore += step[0];
      bend += step[1];
      pressure += step[2];
    }
    const Deformation q{stretch + 0.002 - 1, 0, bore, bend, 0};
    const auto balance = full_balance(section, quadrature, q, pressure);
    if (!balance) break;  // a column leaves its law
    ASSERT_LT(missing_step(*balance), 1e-9);
    ASSERT_GT(pressure, before);
    ASSERT_TRUE(positive_definite(balance->stiffness)) << pressure;
    before = pressure;
    if (std::abs(bend) > most_bend) {
      most_bend = std::abs(bend);
      at_most = pressure;
    }
  }
  std::printf("pressure rises up to %.2f kPa at stretch %.3f; bends most, %.3f deg, at %.2f kPa\n",
              before * 1000, stretch, most_bend * 85 / degree, at_most * 1000);
  const auto response = predict(prepared, std::vector<double>{before * 1000 - 1});
  ASSERT_EQ(response.status, Status::ok) << response.message;
  EXPECT_TRUE(response.critical_points.empty());
  EXPECT_GT(before, 0.1);
  EXPECT_NEAR(response.angle_extrema.at(0).pressure_kpa, at_most * 1000, 0.5);
  EXPECT_NEAR(bend_deg(response.angle_extrema.at(0).state), most_bend * 85 / degree, 1e-3);
}

TEST(TurningPoints, TheEndOfAHorseshoesLawIsNamed) {
  const auto response = predict(columns(halves(16, 4, 2)), {}, std::vector<double>{1000});
  EXPECT_EQ(response.status, Status::not_converged);
  EXPECT_NE(response.message.find("its law ends at -0.3 and 1.07"), std::string::npos)
      << response.message;
  std::printf("%s\n", response.message.c_str());
}

/// Two families of straight or horseshoe strands, at most one of them uneven.
Segment random_segment(Random& random) {
  Segment segment = paper_segment({});
  segment.liner.thickness_mm = random.between(1, 6);
  if (random.chance(0.4)) segment.lattice->rings.reset();
  const double radius = random.between(1.5, 4);
  for (int i = 0; i < 2; ++i) {
    const bool uneven = i == 0 && random.chance(0.5);
    const double width = random.between(0.3, 1.5);
    const int count = random.integer(2, 8);
    Grid grid{random.between(20, 160), std::vector<double>(count, width), StraightPath{}};
    if (uneven) grid.widths_mm = halves(count, width, random.between(0.3, 1.5));
    if (uneven && random.chance(0.3)) grid.widths_mm[0] = random.between(0.3, 1.5);
    if (random.chance(0.6)) grid.path = Horseshoe{radius, random.between(90, 200), true};
    segment.lattice->grids.push_back(grid);
  }
  return segment;
}

/// Pressures at which an angle has an extreme in a dense sweep. Passing through zero is none.
std::vector<double> extremes(const std::vector<State>& sweep, AngleKind quantity) {
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < sweep.size(); ++i) {
    const State& a = sweep[i - 1];
    const State& b = sweep[i + 1];
    const double here = angle_of(sweep[i], quantity);
    const double same_way = quantity == AngleKind::twist
                                ? a.twist_rad_per_mm * b.twist_rad_per_mm
                                : a.bend_rad_per_mm[0] * b.bend_rad_per_mm[0] +
                                      a.bend_rad_per_mm[1] * b.bend_rad_per_mm[1];
    if (same_way <= 0 || here < 1e-8) continue;
    const double rise = here - angle_of(a, quantity);
    if (rise * (angle_of(b, quantity) - here) < 0) found.push_back(sweep[i].pressure_kpa);
  }
  return found;
}

TEST(TurningPoints, AreThoseOfADenseSweep) {
  std::printf("seed 61\n");
  Random random(61);
  std::array<int, 2> turns{};
  double worst_slope = 0;
  for (int design = 0; design < 45; ++design) {
    const PreparedSegment segment = prepare_segment(random_segment(random), {});
    const double end = random.between(20, 100);
    const Response response = predict(segment, std::vector<double>{end});
    if (!response.states[0]) continue;
    std::vector<double> pressures;
    for (int i = 1; i <= 120; ++i) pressures.push_back(end * i / 120);
    std::vector<State> sweep;
    for (const auto& state : predict(segment, pressures).states) sweep.push_back(state.value());
    for (const auto quantity : {AngleKind::bend, AngleKind::twist}) {
      SCOPED_TRACE("design " + std::to_string(design) +
                   (quantity == AngleKind::bend ? ", bending, up to " : ", twist, up to ") +
                   std::to_string(end));
      const std::vector<double> expected = extremes(sweep, quantity);
      std::vector<AngleExtremum> found;
      for (const AngleExtremum& turning : response.angle_extrema) {
        // At the ends of the sweep there is nothing to compare with.
        const bool inside = turning.pressure_kpa > end / 100 && turning.pressure_kpa < 0.99 * end;
        if (turning.quantity == quantity && inside) found.push_back(turning);
      }
      for (const double pressure : expected) {
        if (pressure <= end / 100 || pressure >= 0.99 * end) continue;
        EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const AngleExtremum& turning) {
                                  return std::abs(turning.pressure_kpa - pressure) <
                                         1.01 * end / 120;
                                }))
            << "missed at " << pressure;
      }
      for (const AngleExtremum& turning : found) {
        EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](double pressure) {
          return std::abs(turning.pressure_kpa - pressure) < 1.01 * end / 120;
        })) << turning.name;
        worst_slope = std::max(worst_slope, std::abs(relative_slope(segment, turning)));
        ++turns[quantity == AngleKind::twist ? 1 : 0];
      }
    }
  }
  std::printf("%d turns of bending, %d of twist; largest relative slope there %.1e\n", turns[0],
              turns[1], worst_slope);
  EXPECT_GT(turns[0], 3);
  EXPECT_GT(turns[1], 3);
  EXPECT_LT(worst_slope, 1e-5);
}

}  // namespace
}  // namespace latticast::testing
