// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/horseshoe/horseshoe_law.h"

namespace latticast {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(HorseshoeFibre, IsThatOfACurvedBeamAtSmallStrains) {
  for (const double arc_deg : {40.0, 120.0, 180.0, 250.0}) {
    const HorseshoeShape shape{3, arc_deg * degree, 0.6, 2, 19.46};
    const double strain = 1e-6;
    const double force = make_law(shape).at(strain)->force_n;
    const double area = 0.6 * 2;
    const double moment = force * 3 * (1 - std::cos(shape.arc_rad / 2));
    const double expected = force / (19.46 * area) + moment * 6 / (19.46 * 2 * 0.6 * 0.6);
    EXPECT_NEAR(*largest_fibre_strain(shape, strain) / expected, 1, 1e-4) << arc_deg;
  }
}

// The moment in mid-arc is the force times the arc's height over the force line, here by walking
// the bent arc with midpoint steps from its middle.
TEST(HorseshoeFibre, IsThatOfTheWalkedArc) {
  const HorseshoeShape shape{2.65625, 180 * degree, 2, 2, 19.46};
  const StrandLaw law = make_law(shape);
  const double area = 4;
  const double stiffness = 19.46 * 2 * 8 / 12;
  for (const double strain : {-0.2, -0.05, 0.1, 0.3, 0.55, 0.8}) {
    const double force = law.at(strain)->force_n;
    const double fibre = *largest_fibre_strain(shape, strain);
    const double axial = force / (19.46 * area);
    const double bending = (fibre - axial) / (0.5 * 2 / shape.radius_mm);
    const double turning = force > 0 ? 1 - bending : 1 + bending;
    // theta'' = beta sin theta (1 + delta cos theta) must end with theta' = 1.
    const double beta = force * shape.radius_mm * shape.radius_mm / stiffness;
    double slope = 0;
    double rate = turning;
    double height = 0;
    constexpr int steps = 4000;
    const double step = shape.arc_rad / 2 / steps;
    const auto bend = [&](double at) { return beta * std::sin(at) * (1 + axial * std::cos(at)); };
    for (int i = 0; i < steps; ++i) {
      const double middle = slope + 0.5 * step * (rate + 0.5 * step * bend(slope));
      const double next = rate + step * bend(middle);
      slope += 0.5 * step * (rate + next);
      rate = next;
      height += step * (1 + axial * std::cos(middle)) * std::sin(middle);
    }
    EXPECT_NEAR(rate, 1, 1e-5) << strain;
    const double moment = std::abs(force) * height * shape.radius_mm;
    EXPECT_NEAR(moment * shape.radius_mm / stiffness / bending, 1, 1e-4) << strain;
  }
}

TEST(HorseshoeFibre, RestsAtRest) {
  EXPECT_EQ(*largest_fibre_strain({3, 180 * degree, 1, 2, 19.46}, 0), 0);
}

}  // namespace
}  // namespace latticast
