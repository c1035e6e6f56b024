// SPDX-License-Identifier: GPL-3.0-or-later
// The liner's energy of every law against an integral of its author's formula, principal stretches
// by eigenvalues, tanh-sinh quadrature and differences in long double.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "model/section/quadrature.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "tests/unit/design/material/literal_laws.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

using Real = long double;
using Coordinates = std::array<Real, 3>;  // elongation, twist, inner growth

constexpr double inner_mm = 12;
constexpr double outer_mm = 16;

/// tanh-sinh over (from, to); integrands here are analytic on the closed interval.
Real integral(Real from, Real to, const std::function<Real(Real)>& f) {
  const Real step = 1.0L / 16;
  const Real half_pi = std::numbers::pi_v<Real> / 2;
  Real sum = 0;
  for (int i = -56; i <= 56; ++i) {
    const Real t = i * step;
    const Real x = std::tanh(half_pi * std::sinh(t));
    const Real cosh = std::cosh(half_pi * std::sinh(t));
    sum += half_pi * std::cosh(t) / (cosh * cosh) * f((from + to) / 2 + (to - from) / 2 * x);
  }
  return sum * step * (to - from) / 2;
}

Stretches principal_stretches(const Coordinates& q, Real radius) {
  const Real stretch = 1 + q[0];
  const Real bore = inner_mm + q[2];
  const Real r = std::sqrt(bore * bore + (radius * radius - inner_mm * inner_mm) / stretch);
  const Real hoop = r / radius;
  const Real shear = q[1] * r;
  // Eigenvalues of F F^T, F = [hoop, shear; 0, stretch].
  const Real mean = (hoop * hoop + shear * shear + stretch * stretch) / 2;
  const Real half = (hoop * hoop + shear * shear - stretch * stretch) / 2;
  const Real larger = std::sqrt(mean + std::hypot(half, shear * stretch));
  const Real product = hoop * stretch;
  return {larger, product / larger, 1 / product};
}

Real literal_tube(const Law& law, const Coordinates& q) {
  return integral(inner_mm, outer_mm, [&](Real radius) {
    return literal_energy(law, principal_stretches(q, radius)) * 2 * std::numbers::pi_v<Real> *
           radius;
  });
}

/// Steps of the differences, for changes of stretch of 0.002.
constexpr Coordinates steps = {2e-3L, 1.3e-4L, 0.026L};

Real slope(const std::function<Real(Real)>& f, Real h) {
  return (672 * (f(h) - f(-h)) - 168 * (f(2 * h) - f(-2 * h)) + 32 * (f(3 * h) - f(-3 * h)) -
          3 * (f(4 * h) - f(-4 * h))) /
         (840 * h);
}

Coordinates stepped(Coordinates q, int i, Real by) {
  q[i] += by;
  return q;
}

const std::vector<Coordinates> states = {{0, 0, 0},          {0.15L, 0, 0},      {0, 0.01L, 0},
                                         {0, 0, 2},          {0.12L, 0, 1.5L},   {0.3L, 0.02L, 3},
                                         {-0.1L, 0.005L, 1}, {0.1L, -0.03L, -1}, {0.6L, 0, 7}};

TEST(RubberTube, EnergyIsTheIntegralOfTheFormula) {
  for (const Law& law : example_rubbers()) {
    const Section section = prepare_section(tube(inner_mm, outer_mm, law), {});
    const Quadrature points = make_quadrature(section, 30, 1);
    for (const Coordinates& q : states) {
      SCOPED_TRACE(law_text(law) + " at elongation " + std::to_string(q[0]) + ", twist " +
                   std::to_string(q[1]) + ", growth " + std::to_string(q[2]));
      const auto energy = stored_energy(
          section, points,
          {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), 0, 0});
      ASSERT_TRUE(energy);
      const auto expected = static_cast<double>(literal_tube(law, q));
      EXPECT_NEAR(energy->value, expected, 1e-12 * std::abs(expected) + 1e-17);
      for (int i = 0; i < 3; ++i) {
        const auto by = [&](int j, const Coordinates& from) {
          return slope([&](Real h) { return literal_tube(law, stepped(from, j, h)); }, steps[j]);
        };
        const double size = energy->second(i, i) * static_cast<double>(steps[i]) * 1000;
        EXPECT_NEAR(energy->gradient[i], static_cast<double>(by(i, q)), 1e-10 * size) << i;
        for (int j = i; j < 3; ++j) {
          const Real second = slope([&](Real h) { return by(j, stepped(q, i, h)); }, steps[i]);
          const double scale = std::sqrt(energy->second(i, i) * energy->second(j, j));
          EXPECT_NEAR(energy->second(i, j), static_cast<double>(second), 1e-9 * scale)
              << i << ", " << j;
        }
      }
    }
  }
}

/// A thick Mooney cylinder that is widened in plane strain. The wall is incompressible, so that the
/// pressure is dW/d(pi a^2) at the held length.
TEST(RubberTube, MooneyCylinderWidensAsPublished) {
  const double inner = 7;
  const Section section = prepare_section(tube(inner, 18.625, Mooney{80, 20}), {});
  const Quadrature points = make_quadrature(section, 40, 1);
  const auto pressure = [&](double growth) {
    const auto energy = stored_energy(section, points, {0, 0, growth, 0, 0});
    return energy->gradient[coordinate::inner_growth] / (2 * pi * (inner + growth));
  };
  struct Published {
    double pressure, growth, hoop_stress;
  };
  for (const Published& p : {Published{50, 1.2406129, 82.86076},
                             {100, 3.2115017, 231.62883},
                             {150, 7.1818714, 622.19451}}) {
    EXPECT_NEAR(pressure(p.growth), p.pressure, 1e-5);
    double low = 0;
    double high = 50;
    while (high - low > 1e-12) {
      const double middle = 0.5 * (low + high);
      (pressure(middle) < p.pressure ? low : high) = middle;
    }
    EXPECT_NEAR(low, p.growth, 1e-7);
    // Cauchy stress around the bore, less the pressure on it.
    const double hoop = 1 + low / inner;
    const EnergyDensity w =
        energy_density(section.liner_law, {0, (hoop - 1 / hoop) * (hoop - 1 / hoop)});
    const double difference = 2 * w.by_distortion * (hoop * hoop - 1 / (hoop * hoop));
    EXPECT_NEAR(difference - p.pressure, p.hoop_stress, 1e-4);
  }
  // Widened without end, it bears 2 (c10 + c01) ln(R_o/R_i).
  EXPECT_NEAR(pressure(1e5), 200 * std::log(18.625 / 7), 1e-5);
}

}  // namespace
}  // namespace latticast::testing
