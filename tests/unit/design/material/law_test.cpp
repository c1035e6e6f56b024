// SPDX-License-Identifier: GPL-3.0-or-later
// Every rubber against its author's formula in principal stretches: values directly, derivatives by
// differences in long double, at rest and where stretches coincide from one side.
#include "design/material/law.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "design/material_library.h"
#include "tests/unit/design/material/literal_laws.h"

namespace latticast::testing {
namespace {

using Real = long double;
using Function = std::function<Real(Real)>;

/// Principal stretches of a plane with these measures.
Stretches stretches_of(Real area, Real distortion) {
  const Real product = 1 + area;
  const Real half = std::sqrt(distortion) / 2;
  const Real larger = half + std::sqrt(half * half + product);
  return {larger, product / larger, 1 / product};
}

InPlaneStretch plane_of(const Stretches& stretches) {
  const Real difference = stretches[0] - stretches[1];
  return {static_cast<double>(stretches[0] * stretches[1] - 1),
          static_cast<double>(difference * difference)};
}

Real central_slope(const Function& f, Real at, Real h) {
  return (45 * (f(at + h) - f(at - h)) - 9 * (f(at + 2 * h) - f(at - 2 * h)) +
          (f(at + 3 * h) - f(at - 3 * h))) /
         (60 * h);
}

Real forward_slope(const Function& f, Real at, Real h) {
  constexpr Real weights[] = {-147, 360, -450, 400, -225, 72, -10};
  Real sum = 0;
  for (int i = 0; i < 7; ++i) sum += weights[i] * f(at + i * h);
  return sum / (60 * h);
}

struct Place {
  double area;
  double distortion;
};

// Rest, equibiaxial tension and compression, uniaxial, planar, and large ones.
const std::vector<Place> places = {{0, 0},       {0.44, 0},  {-0.3, 0},    {1.5, 0},
                                   {0, 0.01},    {0.2, 0.3}, {0.5, 0.25},  {-0.4, 0.02},
                                   {0, 1.5},     {1.2, 0.9}, {1e-3, 2e-6}, {0.7, 1e-9},
                                   {-0.2, 3e-4}, {0.3, 2.0}, {-0.1, 0.6}};

TEST(Laws, EnergyIsTheFormulaInPrincipalStretches) {
  for (const Law& law : example_rubbers()) {
    for (const Place& place : places) {
      const Real expected = literal_energy(law, stretches_of(place.area, place.distortion));
      const double found = energy_density(law, {place.area, place.distortion}).value;
      EXPECT_NEAR(found, static_cast<double>(expected),
                  2e-14 * std::abs(static_cast<double>(expected)) + 1e-18)
          << law_text(law) << " at " << place.area << ", " << place.distortion;
    }
  }
}

TEST(Laws, DerivativesAreThoseOfTheFormula) {
  for (const Law& law : example_rubbers()) {
    for (const Place& p : places) {
      SCOPED_TRACE(law_text(law) + " at " + std::to_string(p.area) + ", " +
                   std::to_string(p.distortion));
      const EnergyDensity exact = energy_density(law, {p.area, p.distortion});
      const auto slope = [](const Function& f, Real at) {
        return static_cast<double>(at < 0.01 ? forward_slope(f, at, 1e-3L)
                                             : central_slope(f, at, 1e-3L));
      };
      const auto by_area = [&](const Function& f) {
        return static_cast<double>(central_slope(f, p.area, 1e-3L));
      };
      const double size = std::abs(exact.by_area_area) + std::abs(exact.by_distortion);
      EXPECT_NEAR(exact.by_area, by_area([&](Real u) {
                    return literal_energy(law, stretches_of(u, p.distortion));
                  }),
                  1e-11 * size);
      EXPECT_NEAR(
          exact.by_distortion,
          slope([&](Real w) { return literal_energy(law, stretches_of(p.area, w)); }, p.distortion),
          1e-11 * size);
      const auto at = [&](Real u, Real w) {
        return energy_density(law, {static_cast<double>(u), static_cast<double>(w)});
      };
      EXPECT_NEAR(exact.by_area_area, by_area([&](Real u) { return at(u, p.distortion).by_area; }),
                  1e-10 * size);
      EXPECT_NEAR(exact.by_area_distortion,
                  by_area([&](Real u) { return at(u, p.distortion).by_distortion; }), 1e-10 * size);
      EXPECT_NEAR(exact.by_area_distortion,
                  slope([&](Real w) { return at(p.area, w).by_area; }, p.distortion), 1e-10 * size);
      EXPECT_NEAR(exact.by_distortion_distortion,
                  slope([&](Real w) { return at(p.area, w).by_distortion; }, p.distortion),
                  1e-10 * size);
    }
  }
}

TEST(Laws, RestIsExactlyZeroAndSmallStrainsKeepTheirAccuracy) {
  for (const Law& law : example_rubbers()) {
    SCOPED_TRACE(law_text(law));
    const EnergyDensity rest = energy_density(law, {0, 0});
    EXPECT_EQ(rest.value, 0);
    EXPECT_EQ(rest.by_area, 0);
    const double modulus = rest_shear_modulus_mpa(law);
    EXPECT_NEAR(rest.by_distortion, modulus / 2, 1e-15 * modulus);
    EXPECT_NEAR(rest.by_area_area, 3 * modulus, 1e-14 * modulus);
    // Linear elasticity: mu times the squared principal strains.
    for (const double strain : {1e-6, 1e-8}) {
      const double second = -0.3 * strain;
      const double difference = strain - second;
      const double found =
          energy_density(law, {strain + second + strain * second, difference * difference}).value;
      const double third = strain + second;
      const double expected = modulus * (strain * strain + second * second + third * third);
      EXPECT_NEAR(found / expected, 1, 20 * strain);
    }
  }
}

/// An isotropic law does not know which of its principal planes is meant.
TEST(Laws, AllPrincipalPlanesAreEqual) {
  for (const Law& law : example_rubbers()) {
    const Stretches s = {1.3L, 0.9L, 1 / (1.3L * 0.9L)};
    const double value = energy_density(law, plane_of(s)).value;
    EXPECT_NEAR(energy_density(law, plane_of({s[1], s[2], s[0]})).value, value, 1e-14 * value);
    EXPECT_NEAR(energy_density(law, plane_of({s[2], s[0], s[1]})).value, value, 1e-14 * value);
  }
}

void expect_same_energy(const Law& a, const Law& b) {
  for (const Place& p : places) {
    const EnergyDensity x = energy_density(a, {p.area, p.distortion});
    const EnergyDensity y = energy_density(b, {p.area, p.distortion});
    const double size = 2e-15 * (std::abs(x.by_area_area) + std::abs(x.by_area) + x.value);
    EXPECT_NEAR(x.value, y.value, size);
    EXPECT_NEAR(x.by_area, y.by_area, size);
    EXPECT_NEAR(x.by_distortion, y.by_distortion, size);
    EXPECT_NEAR(x.by_area_area, y.by_area_area, size);
    EXPECT_NEAR(x.by_area_distortion, y.by_area_distortion, size);
    EXPECT_NEAR(x.by_distortion_distortion, y.by_distortion_distortion, size);
  }
}

/// [Ogden 1972] contains both.
TEST(Laws, OgdenOfPowersTwoIsNeoHookeanAndMooney) {
  expect_same_energy(NeoHookean{0.08}, Ogden{{0.08}, {2}});
  expect_same_energy(NeoHookean{0.08}, Ogden{{0.05, 0.03}, {2, 2}});
  expect_same_energy(Mooney{0.03, 0.01}, Ogden{{0.06, -0.02}, {2, -2}});
  expect_same_energy(Mooney{0.05, -0.005}, Ogden{{0.1, 0.01}, {2, -2}});
}

/// The series of the power sum goes over into its closed form.
TEST(Laws, OgdenIsSmoothInTheDistortion) {
  for (const double alpha : {-50.0, -7.3, 0.001, 1.0, 3.0, 20.0, 50.0}) {
    const Ogden law{{1 / alpha}, {alpha}};
    const double below = 0.4 * (1 - 1e-14);  // z = 0.1 at area 0
    const EnergyDensity series = law.energy_density({0, below});
    const EnergyDensity closed = law.energy_density({0, 0.4 * (1 + 1e-14)});
    EXPECT_NEAR(series.value / closed.value, 1, 2e-12) << alpha;
    EXPECT_NEAR(series.by_distortion / closed.by_distortion, 1, 2e-12) << alpha;
    EXPECT_NEAR(series.by_area_distortion / closed.by_area_distortion, 1, 1e-11) << alpha;
    EXPECT_NEAR(series.by_distortion_distortion / closed.by_distortion_distortion, 1, 1e-11)
        << alpha;
  }
}

TEST(Laws, ScalingIsProportional) {
  for (const Law& law : example_rubbers()) {
    const InPlaneStretch at{0.3, 0.2};
    const Law stiffer = scaled(law, 1.7);
    EXPECT_NEAR(energy_density(stiffer, at).value, 1.7 * energy_density(law, at).value, 1e-15);
    EXPECT_EQ(first_invariant_limit(stiffer), first_invariant_limit(law));
  }
}

TEST(Laws, FaultsBetweenConstantsAreNamed) {
  for (const Law& law : example_rubbers()) EXPECT_EQ(law_fault(law), "") << law_text(law);
  for (const FaultyLaw& faulty : faulty_laws()) {
    EXPECT_NE(law_fault(faulty.law).find(faulty.reason), std::string::npos)
        << law_text(faulty.law) << ": " << law_fault(faulty.law);
  }
  // A constant that was refused by itself is not blamed twice.
  EXPECT_EQ(law_fault(NeoHookean{std::nan("")}), "");
}

std::string written(const Law& law) {
  std::string text = fmt::format("[written]\nlaw = \"{}\"\nsource = \"a test\"\n", law_name(law));
  for (const LawConstant& constant : constants_of(law)) {
    text += constant.is_list
                ? fmt::format("{} = [{}]\n", constant.key, fmt::join(constant.values, ", "))
                : fmt::format("{} = {}\n", constant.key, constant.values.front());
  }
  return text;
}

TEST(Laws, AreReadAsTheyAreWritten) {
  std::vector<Law> laws = example_rubbers();
  laws.emplace_back(Linear{19.46, 0.3});
  for (const Law& law : laws) {
    MaterialLibrary library;
    for (const Issue& issue : add_materials(written(law), library)) {
      ADD_FAILURE() << describe(issue, written(law));
    }
    ASSERT_EQ(library.count("written"), 1U) << written(law);
    EXPECT_EQ(written(library.at("written").law), written(law));
  }
}

TEST(Laws, FaultsAreRefusedWhereTheyAreWritten) {
  for (const FaultyLaw& faulty : faulty_laws()) {
    MaterialLibrary library;
    EXPECT_FALSE(add_materials(written(faulty.law), library).empty()) << written(faulty.law);
  }
}

TEST(Laws, TextNamesEveryConstantWithItsUnit) {
  EXPECT_EQ(law_text(Linear{19.46, 0.499}), "linear, E = 19.46 MPa, nu = 0.499");
  EXPECT_EQ(law_text(NeoHookean{0.08}), "neo-hookean, mu = 0.08 MPa");
  EXPECT_EQ(law_text(Yeoh{0.04, 0, -0.1}), "yeoh, c1 = 0.04, c2 = 0, c3 = -0.1 MPa");
  EXPECT_EQ(law_text(Gent{0.08, 60}), "gent, mu = 0.08 MPa, jm = 60");
  EXPECT_EQ(law_text(Mooney{0.03, 0.01}), "mooney, c10 = 0.03, c01 = 0.01 MPa");
  EXPECT_EQ(law_text(Ogden{{0.63, -0.01}, {1.3, -2}}),
            "ogden, mu = [0.63, -0.01] MPa, alpha = [1.3, -2]");
}

}  // namespace
}  // namespace latticast::testing
