// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/horseshoe_law.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "model/horseshoe/arc_equilibrium.h"
#include "model/numerics/gauss.h"
#include "model/strand/links.h"
#include "tests/unit/model/horseshoe/horseshoe_shooting.h"

namespace latticast {
namespace {

constexpr double degree = std::numbers::pi / 180;

HorseshoeShape shape_of(double arc_deg, double slenderness) {
  return {2.5, arc_deg * degree, 2.5 * slenderness, 2, 19.46};
}

Arc arc_of(const HorseshoeShape& shape) {
  return {shape.arc_rad / 2, std::pow(shape.width_mm / shape.radius_mm, 2) / 12};
}

double force_unit_n(const HorseshoeShape& shape) {
  return shape.youngs_modulus_mpa * shape.thickness_mm * std::pow(shape.width_mm, 3) / 12 /
         std::pow(shape.radius_mm, 2);
}

struct ReferenceRow {
  double radius_mm, arc_deg, width_mm, strain, force_n, beta, delta;
};

std::vector<ReferenceRow> reference_rows() {
  std::ifstream file(LATTICAST_SOURCE_DIR "/tests/golden/horseshoe.csv");
  std::vector<ReferenceRow> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    for (char& letter : line) letter = letter == ',' ? ' ' : letter;
    ReferenceRow row{};
    std::istringstream(line) >> row.radius_mm >> row.arc_deg >> row.width_mm >> row.strain >>
        row.force_n >> row.beta >> row.delta;
    rows.push_back(row);
  }
  return rows;
}

TEST(HorseshoeLaw, EveryReferenceRow) {
  const std::vector<ReferenceRow> rows = reference_rows();
  ASSERT_EQ(rows.size(), 96U);
  for (const ReferenceRow& row : rows) {
    const HorseshoeShape shape{row.radius_mm, row.arc_deg * degree, row.width_mm, 2, 19.46};
    const StrandLaw law = make_law(shape);
    const auto at = law.at(row.strain);
    ASSERT_TRUE(at);
    const double beta = law.table().at(row.strain)->force;
    const double delta = at->force_n / (19.46 * row.width_mm * 2);
    for (const double ratio : {at->force_n / row.force_n, beta / row.beta, delta / row.delta}) {
      EXPECT_NEAR(ratio, 1, 1e-9) << row.arc_deg << " " << row.width_mm << " " << row.strain;
    }
  }
}

TEST(HorseshoeLaw, HoldsOverTheWholeScope) {
  for (const double arc_deg : {20, 30, 60, 100, 140, 180, 220, 260, 300}) {
    for (const double slenderness : {1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1., 3., 10., 30., 100.}) {
      SCOPED_TRACE(testing::Message() << "arc " << arc_deg << " degrees, w/R " << slenderness);
      const StrandLaw law = make_law(shape_of(arc_deg, slenderness));
      EXPECT_EQ(law.range().lowest, -0.3);
      EXPECT_EQ(law.range().highest, full_extension(std::get<HorseshoeShape>(law.shape())) + 0.5);
      EXPECT_LT(law.accuracy().force_error, ForceTable::tolerance / 4);
      EXPECT_LT(law.accuracy().slope_error, 1e-8);
      EXPECT_LT(law.accuracy().defect, 1e-11);
      EXPECT_GE(law.accuracy().check_points, 4);
      double before = -std::numeric_limits<double>::infinity();
      for (int i = 0; i <= 400; ++i) {
        const double t = i / 400.0;
        const auto at = law.at(law.range().lowest * (1 - t) + law.range().highest * t);
        ASSERT_TRUE(at);
        EXPECT_GT(at->force_n, before);
        EXPECT_GT(at->slope_n, 0);
        EXPECT_GE(at->energy_nmm, 0);
        before = at->force_n;
      }
    }
  }
}

TEST(HorseshoeLaw, RandomShapesAgainstSolvesAndShooting) {
  constexpr unsigned seed = 20240607;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 60; ++i) {
    const HorseshoeShape shape =
        shape_of(20 + 280 * unit(random), std::pow(10, -3 + 5 * unit(random)));
    const StrandLaw law = make_law(shape);
    const ArcSolver solver(arc_of(shape));
    for (int j = 0; j < 25; ++j) {
      // Every other strain is next to full extension, where thin arcs turn stiff.
      const double middle = full_extension(shape) * (1 + 0.1 * std::pow(2 * unit(random) - 1, 5));
      const double t = unit(random);
      const double any = law.range().lowest * (1 - t) + law.range().highest * t;
      const double strain = j % 2 == 0 ? any : middle;
      SCOPED_TRACE(testing::Message()
                   << "shape " << i << ": arc " << shape.arc_rad / degree << " degrees, w/R "
                   << shape.width_mm / shape.radius_mm << ", strain " << strain);
      const auto solved = solver.advance(solver.rest(), strain);
      ASSERT_TRUE(solved);
      const ForceTable::State at = *law.table().at(strain);
      EXPECT_NEAR(at.force / solved->bent.force, 1, 1e-9);
      EXPECT_NEAR(at.slope / solved->force_by_strain, 1, 1e-7);
      if (j >= 2) continue;
      const Shot shot = shoot_free_end(solver.arc(), at.force, solver.end_slope_rad(*solved));
      const long double sine = std::sin(static_cast<long double>(shape.arc_rad / 2));
      const auto miss = static_cast<double>(shot.half_chord / sine - 1 - strain);
      EXPECT_LT(std::abs(miss * at.slope / at.force), 1e-9);
    }
  }
}

TEST(HorseshoeLaw, EnergyIsWhatTheArcStores) {
  // Bending and stretching energy of the shot arc against the integral of force by chord.
  for (const double arc_deg : {20, 120, 180, 300}) {
    for (const double slenderness : {1e-2, 0.4, 2.0, 100.0}) {
      const HorseshoeShape shape = shape_of(arc_deg, slenderness);
      const StrandLaw law = make_law(shape);
      const ArcSolver solver(arc_of(shape));
      for (const double strain : {-0.3, 0.5 * full_extension(shape), law.range().highest}) {
        const auto solved = solver.advance(solver.rest(), strain);
        ASSERT_TRUE(solved);
        const Shot shot =
            shoot_free_end(solver.arc(), solved->bent.force, solver.end_slope_rad(*solved));
        const double stored =
            2 * static_cast<double>(shot.half_energy) * force_unit_n(shape) * shape.radius_mm;
        EXPECT_NEAR(law.at(strain)->energy_nmm / stored, 1, 1e-9)
            << arc_deg << " " << slenderness << " " << strain;
      }
    }
  }
}

TEST(HorseshoeLaw, EnergyForceAndSlopeBelongTogether) {
  const GaussRule rule = gauss_legendre(12);
  for (const double slenderness : {1e-3, 0.2, 1.6, 100.0}) {
    const StrandLaw law = make_law(shape_of(170, slenderness));
    const double chord = law.rest_chord_mm();
    const std::vector<double>& breaks = law.table().breaks();
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      const double length = breaks[i] - breaks[i - 1];
      const auto at = [&](double t) { return *law.at(breaks[i - 1] + t * length); };
      double work = 0;
      double rise = 0;
      for (std::size_t j = 0; j < rule.points.size(); ++j) {
        const LinkState state = at(0.05 + 0.9 * (1 + rule.points[j]) / 2);
        work += rule.weights[j] / 2 * 0.9 * length * state.force_n * chord;
        rise += rule.weights[j] / 2 * 0.9 * length * state.slope_n;
      }
      const LinkState low = at(0.05);
      const LinkState high = at(0.95);
      const double force = std::max(std::abs(low.force_n), std::abs(high.force_n));
      EXPECT_NEAR(high.energy_nmm - low.energy_nmm, work,
                  1e-13 * (force * length * chord + high.energy_nmm + low.energy_nmm));
      // A strain is only known to its own rounding, which a steep force shows.
      const double steep = std::max(low.slope_n, high.slope_n);
      EXPECT_NEAR(high.force_n - low.force_n, rise, 1e-13 * force + 1e-15 * steep);
      const double step = 1e-4;
      const double slope = (at(0.5 + step).force_n - at(0.5 - step).force_n) / (2 * step * length);
      EXPECT_NEAR(slope / at(0.5).slope_n, 1, 1e-6);
    }
  }
}

TEST(HorseshoeLaw, PiecesMeet) {
  for (const double slenderness : {1e-3, 0.5}) {
    const StrandLaw law = make_law(shape_of(240, slenderness));
    const std::vector<double>& breaks = law.table().breaks();
    ASSERT_GT(breaks.size(), 3U);
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
      if (breaks[i] == 0) continue;
      const double below = std::nextafter(breaks[i], -1.0);
      EXPECT_NEAR(law.at(below)->energy_nmm / law.at(breaks[i])->energy_nmm, 1, 1e-12);
      EXPECT_NEAR(law.at(below)->force_n / law.at(breaks[i])->force_n, 1, 1e-11);
      EXPECT_NEAR(law.at(below)->slope_n / law.at(breaks[i])->slope_n, 1, 1e-7);
    }
  }
}

TEST(HorseshoeLaw, ExactAtRestAndRelativeNextToIt) {
  const HorseshoeShape shape = shape_of(170, 0.6);
  const StrandLaw law = make_law(shape);
  const double phi = shape.arc_rad / 2;
  const double radius = shape.radius_mm;
  const double bending = std::pow(radius, 3) / (force_unit_n(shape) * radius * radius) *
                         (phi * (2 + std::cos(2 * phi)) - 1.5 * std::sin(2 * phi));
  const double stretching = radius /
                            (shape.youngs_modulus_mpa * shape.width_mm * shape.thickness_mm) *
                            (phi + std::sin(2 * phi) / 2);
  const double closed_form = 2 * radius * std::sin(phi) / (bending + stretching);
  EXPECT_EQ(law.at(0)->energy_nmm, 0);
  EXPECT_EQ(law.at(0)->force_n, 0);
  EXPECT_NEAR(law.at(0)->slope_n / closed_form, 1, 1e-12);
  for (const double strain : {1e-6, -1e-8, 1e-12, -1e-15, 1e-100}) {
    const LinkState at = *law.at(strain);
    EXPECT_NEAR(at.force_n / (closed_form * strain), 1, 10 * std::abs(strain) + 1e-10);
    const double energy = closed_form * strain * strain / 2 * rest_chord_mm(shape);
    if (energy == 0) continue;
    EXPECT_NEAR(at.energy_nmm / energy, 1, 10 * std::abs(strain) + 1e-9);
  }
}

TEST(HorseshoeLaw, NothingOutsideOfTheRange) {
  const HorseshoeShape shape = shape_of(180, 0.8);
  const StrandLaw law = make_law(shape, {-0.1, 0.25});
  EXPECT_TRUE(law.at(-0.1));
  EXPECT_TRUE(law.at(0.25));
  EXPECT_FALSE(law.at(std::nextafter(-0.1, -1.0)));
  EXPECT_FALSE(law.at(std::nextafter(0.25, 1.0)));
  EXPECT_FALSE(law.at(std::nan("")));
  EXPECT_FALSE(law.at(std::numeric_limits<double>::infinity()));
  EXPECT_NEAR(law.at(0.2)->force_n / make_law(shape).at(0.2)->force_n, 1, 1e-9);
  EXPECT_FALSE(make_law(shape, {-0.1, 0}).at(1e-9));
  EXPECT_EQ(make_law(shape, {0, 0.1}).at(0)->force_n, 0);
}

TEST(HorseshoeLaw, RefusesWhatItIsNotMadeFor) {
  const double nan = std::nan("");
  for (const HorseshoeShape& shape :
       {shape_of(19.9, 1), shape_of(300.1, 1), shape_of(180, 0.99e-3), shape_of(180, 101),
        shape_of(nan, 1), shape_of(180, nan), HorseshoeShape{0, 2, 1, 1, 1},
        HorseshoeShape{1, 2, -1, 1, 1}, HorseshoeShape{1, 2, 1, 0, 1},
        HorseshoeShape{1, 2, 1, 1, nan},
        HorseshoeShape{1, 2, 1, 1, std::numeric_limits<double>::infinity()}}) {
    EXPECT_THROW(make_law(shape), LinkOutOfScope);
  }
  const HorseshoeShape good = shape_of(180, 1);
  for (const StrainRange& range :
       {StrainRange{-0.31, 0.1}, StrainRange{-0.1, 5}, StrainRange{0.1, 0.2},
        StrainRange{-0.2, -0.1}, StrainRange{0, 0}, StrainRange{nan, 0.1},
        StrainRange{-0.1, nan}}) {
    EXPECT_THROW(make_law(good, range), LinkOutOfScope);
  }
}

TEST(HorseshoeLaw, DistinctShapesAreSolvedOnceAndInAnyNumberOfThreads) {
  std::vector<LinkShape> shapes;
  shapes.reserve(13);
  for (int i = 0; i < 12; ++i) shapes.push_back(shape_of(160, 0.4 + 0.2 * (i % 5)));
  const auto alone = make_laws(shapes, 1);
  const auto together = make_laws(shapes, 4);
  ASSERT_EQ(alone.size(), shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(alone[i]->shape(), shapes[i]);
    EXPECT_EQ(alone[i], alone[i % 5]);
    EXPECT_EQ(alone[i]->at(0.3)->force_n, together[i]->at(0.3)->force_n);
  }
  EXPECT_NE(alone[0], alone[1]);
  EXPECT_TRUE(make_laws({}).empty());
  shapes.push_back(shape_of(10, 1));
  EXPECT_THROW(make_laws(shapes, 3), LinkOutOfScope);
  // What is no number is no other shape's equal.
  shapes.back() = shapes.front();
  std::get<HorseshoeShape>(shapes.back()).width_mm = std::nan("");
  EXPECT_THROW(make_laws(shapes, 3), LinkOutOfScope);
}

}  // namespace
}  // namespace latticast
