// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sinusoid/sinusoid_law.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "design/units.h"
#include "model/numerics/gauss.h"
#include "model/strand/links.h"
#include "tests/unit/model/sinusoid/wave_shooting.h"

namespace latticast {
namespace {

SinusoidShape shape_of(double slope_deg, double width_over_chord, double chord_mm = 7) {
  return {.amplitude_mm = std::tan(slope_deg * pi / 180) * chord_mm / pi,
          .chord_mm = chord_mm,
          .width_mm = width_over_chord * chord_mm,
          .thickness_mm = 2,
          .youngs_modulus_mpa = 19.46};
}

double moment_of_area(const SinusoidShape& shape) {
  return shape.thickness_mm * std::pow(shape.width_mm, 3) / 12;
}

// Force in N that the table's unit stands for.
double force_unit(const SinusoidShape& shape) {
  return shape.youngs_modulus_mpa * moment_of_area(shape) * std::pow(pi / shape.chord_mm, 2);
}

// The moment at the crest that the model has found there.
double crest_moment(const SinusoidShape& shape, double strain) {
  const Wave wave = wave_of(shape);
  const WaveSolver solver(wave, enough_terms(wave));
  const auto at = solver.advance(solver.rest(), strain);
  double sum = 0;
  for (const double turn : at->turn) sum += turn;
  return sum * std::pow(1 + wave.slope * wave.slope, 0.25);
}

// Shooting with the law's force must give the law's chord and energy.
void expect_shooting_agrees(const SinusoidShape& shape, const StrandLaw& law, double strain) {
  const Wave wave = wave_of(shape);
  const LinkState state = *law.at(strain);
  const double unit = force_unit(shape);
  const double beta = state.force_n / unit;
  // A boundary layer of the initial-value problem grows by exp(sqrt(beta) length).
  const WaveShot shot = shoot_free_end(wave, beta, crest_moment(shape, strain), 60);
  const double found = static_cast<double>(shot.quarter_chord / (pi / 2) - 1);
  const double force_error = std::abs(found - strain) * std::abs(state.slope_n / state.force_n);
  EXPECT_LT(force_error, 1e-8);
  const double energy_unit = unit * shape.chord_mm / pi;
  const double energy = static_cast<double>(2 * shot.quarter_energy) * energy_unit;
  EXPECT_NEAR(energy / state.energy_nmm, 1, 1e-8);
}

TEST(SinusoidLaw, AgreesWithShootingInForceAndEnergy) {
  for (const double slope : {5.0, 30.0, 60.0, 78.0}) {
    for (const double width : {0.1, 0.25, 0.8}) {
      const SinusoidShape shape = shape_of(slope, width);
      const StrandLaw law = make_law(shape);
      for (const double part : {-0.9, -0.4, -0.05, 0.05, 0.4, 0.8, 1.0}) {
        const double strain = part < 0 ? -part * law.range().lowest : part * full_extension(shape);
        SCOPED_TRACE(testing::Message()
                     << "slope " << slope << " w/c " << width << " strain " << strain);
        expect_shooting_agrees(shape, law, strain);
      }
    }
  }
}

TEST(SinusoidLaw, RandomShapesAgreeWithShooting) {
  constexpr unsigned seed = 1313;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const SinusoidShape shape = shape_of(2 + 76 * unit(engine), 0.08 + 0.9 * unit(engine));
    const StrandLaw law = make_law(shape);
    const double strain = unit(engine) < 0.5 ? law.range().lowest * unit(engine)
                                             : full_extension(shape) * unit(engine);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << " trial " << trial << " A " << shape.amplitude_mm << " w "
                 << shape.width_mm << " strain " << strain);
    expect_shooting_agrees(shape, law, strain);
  }
}

TEST(SinusoidLaw, HoldsOverTheWholeScopeAndNeverSnaps) {
  for (const double slope : {1.0, 20.0, 60.0, 80.0}) {
    for (const double width : {1e-3, 0.03, 1.0}) {
      SCOPED_TRACE(testing::Message() << "slope " << slope << " w/c " << width);
      const StrandLaw law = make_law(shape_of(slope, width));
      EXPECT_LT(law.accuracy().force_error, ForceTable::tolerance / 4);
      EXPECT_LT(law.accuracy().defect, 1e-11);
      const auto [lowest, highest] = law.range();
      for (int i = 0; i <= 300; ++i) {
        const double strain = std::min(highest, lowest + (highest - lowest) * i / 300);
        EXPECT_GT(law.at(strain)->slope_n, 0) << strain;
      }
    }
  }
}

TEST(SinusoidLaw, ForceIsTheEnergysDerivative) {
  const GaussRule rule = gauss_legendre(12);
  for (const double width : {0.01, 0.3}) {
    const SinusoidShape shape = shape_of(65, width);
    const StrandLaw law = make_law(shape);
    const std::vector<double>& breaks = law.table().breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const double low = breaks[i];
      const double length = breaks[i + 1] - low;
      double work = 0;
      for (std::size_t j = 0; j < rule.points.size(); ++j) {
        const double strain = low + length * (1 + rule.points[j]) / 2;
        work += rule.weights[j] / 2 * length * law.at(strain)->force_n * shape.chord_mm;
      }
      const double gained = law.at(breaks[i + 1])->energy_nmm - law.at(low)->energy_nmm;
      EXPECT_NEAR(work, gained, 1e-12 * law.at(breaks[i + 1])->energy_nmm + 1e-12 * std::abs(work));
    }
  }
}

// k = E w h/(1 + 6 (A/w)^2), of the strain: shallow waves bend and stretch in series.
TEST(SinusoidLaw, ShallowWavesHaveTheClosedFormStiffness) {
  for (const double amplitude_over_width : {0.2, 1.0, 5.0}) {
    SinusoidShape shape = shape_of(1, 0.5);
    shape.width_mm = shape.amplitude_mm / amplitude_over_width;
    const double straight = shape.youngs_modulus_mpa * shape.width_mm * shape.thickness_mm;
    const double expected = straight / (1 + 6 * amplitude_over_width * amplitude_over_width);
    // The next term is of the order of the slope squared.
    EXPECT_NEAR(make_law(shape).at(0)->slope_n / expected, 1, 1e-3);
  }
}

// At rest bending and stretching are in series: chord/stiffness = integral of y^2/(E I) +
// cos^2/(E A) along the wave.
TEST(SinusoidLaw, StiffnessAtRestIsTheUnitLoadIntegral) {
  const GaussRule rule = gauss_legendre(60);
  for (const double slope : {10.0, 45.0, 79.0}) {
    const SinusoidShape shape = shape_of(slope, 0.2);
    const double modulus = shape.youngs_modulus_mpa;
    const double section = shape.width_mm * shape.thickness_mm;
    double compliance = 0;
    for (int part = 0; part < 20; ++part) {
      for (std::size_t j = 0; j < rule.points.size(); ++j) {
        const double x = pi * (part + (1 + rule.points[j]) / 2) / 20;
        const double tangent = std::tan(slope * pi / 180) * std::cos(x);
        const double speed = std::hypot(1, tangent);
        const double y = shape.amplitude_mm * std::sin(x);
        compliance +=
            rule.weights[j] / 2 / 20 * shape.chord_mm * speed *
            (y * y / (modulus * moment_of_area(shape)) + 1 / (speed * speed * modulus * section));
      }
    }
    EXPECT_NEAR(make_law(shape).at(0)->slope_n * compliance / shape.chord_mm, 1, 1e-9);
  }
}

// Pulled far, a thin strand is a straight rod of its own length.
TEST(SinusoidLaw, StretchesLikeARodBeyondFullExtension) {
  const SinusoidShape shape = shape_of(60, 1e-3);
  const double full = full_extension(shape);
  const StrandLaw law = make_law(shape);
  const double rod = shape.youngs_modulus_mpa * shape.width_mm * shape.thickness_mm;
  const double strain = law.range().highest;
  EXPECT_NEAR(law.at(strain)->force_n / (rod * ((1 + strain) / (1 + full) - 1)), 1, 1e-4);
  EXPECT_NEAR(law.at(strain)->slope_n / (rod / (1 + full)), 1, 1e-4);
}

TEST(SinusoidLaw, FullExtensionIsTheLengthOverTheChord) {
  const SinusoidShape shape = shape_of(70, 0.1);
  constexpr int pieces = 2000;  // midpoints of a periodic function converge exponentially
  double length = 0;
  for (int i = 0; i < pieces; ++i) {
    length += std::hypot(1, std::tan(70 * pi / 180) * std::cos((i + 0.5) * pi / pieces)) / pieces;
  }
  EXPECT_NEAR(full_extension(shape), length - 1, 1e-12);
}

// For small strains the wave bends by f y: the crest has the largest moment and the whole pull.
TEST(SinusoidLaw, FibreStrainAtFirstIsThatOfTheCrest) {
  const SinusoidShape shape = shape_of(50, 0.2);
  const double strain = 1e-6;
  const double force = make_law(shape).at(strain)->force_n;
  const double expected = force / (shape.youngs_modulus_mpa * shape.width_mm * shape.thickness_mm) *
                          (1 + 6 * shape.amplitude_mm / shape.width_mm);
  EXPECT_NEAR(*largest_fibre_strain(shape, strain) / expected, 1, 1e-4);
  EXPECT_EQ(*largest_fibre_strain(shape, 0), 0);
}

TEST(SinusoidLaw, RefusesWhatItIsNotMadeFor) {
  for (const SinusoidShape& shape :
       {shape_of(0.9, 0.1), shape_of(80.5, 0.1), shape_of(45, 0.9e-3), shape_of(45, 1.1),
        SinusoidShape{2, 7, 1, 0, 19}, SinusoidShape{2, 7, 1, 2, std::nan("")}}) {
    EXPECT_THROW(make_law(shape), LinkOutOfScope);
  }
  EXPECT_THROW(make_law(shape_of(45, 0.1), {0.1, 0.2}), LinkOutOfScope);
  EXPECT_THROW(make_law(shape_of(45, 0.1), {-0.4, 0.2}), LinkOutOfScope);
}

TEST(SinusoidLaw, SharesLawsBesideHorseshoes) {
  const SinusoidShape wave = shape_of(45, 0.2);
  const HorseshoeShape arc{2.6, pi, 2, 2, 19.46};
  const std::vector<LinkShape> shapes = {wave, arc, wave, arc};
  const StrandLaws laws = make_laws(shapes, 2);
  EXPECT_EQ(laws[0], laws[2]);
  EXPECT_EQ(laws[1], laws[3]);
  EXPECT_EQ(path_name(laws[0]->shape()), "sinusoid");
  EXPECT_EQ(path_name(laws[1]->shape()), "horseshoe");
}

}  // namespace
}  // namespace latticast
