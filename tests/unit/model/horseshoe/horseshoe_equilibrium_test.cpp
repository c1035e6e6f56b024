// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/horseshoe/arc_equilibrium.h"
#include "model/numerics/gauss.h"
#include "tests/unit/model/horseshoe/horseshoe_shooting.h"

namespace latticast {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double arcs_deg[] = {20, 45, 90, 120, 180, 240, 300};
constexpr double slendernesses[] = {1e-3, 1e-2, 0.1, 0.4, 1, 3, 10, 100};

Arc arc_of(double arc_deg, double slenderness) {
  return {arc_deg * degree / 2, slenderness * slenderness / 12};
}

double full_extension(const Arc& arc) {
  return arc.half_angle_rad / std::sin(arc.half_angle_rad) - 1;
}

// Castigliano: strain by beta is the integral of the squared unit moment, and of the squared unit
// normal force times the compliance, over the half chord.
double rest_flexibility(const Arc& arc) {
  const GaussRule rule = gauss_legendre(40);
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const double alpha = arc.half_angle_rad * (1 + rule.points[i]) / 2;
    const double arm = std::cos(alpha) - std::cos(arc.half_angle_rad);
    sum += rule.weights[i] * (arm * arm + arc.compliance * std::pow(std::cos(alpha), 2));
  }
  return sum * arc.half_angle_rad / 2 / std::sin(arc.half_angle_rad);
}

TEST(HorseshoeEquilibrium, SlopeAtRestIsCastiglianos) {
  for (const double arc_deg : arcs_deg) {
    for (const double slenderness : slendernesses) {
      const Arc arc = arc_of(arc_deg, slenderness);
      const ArcSolver solver(arc);
      // The closed form cancels as the fifth power of the half angle, to 1e-12 at 20 degrees.
      EXPECT_NEAR(solver.rest().force_by_strain * rest_flexibility(arc), 1, 3e-11)
          << arc_deg << " " << slenderness;
      for (const double strain : {1e-7, -1e-7}) {
        const auto at = solver.advance(solver.rest(), strain);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->bent.force / strain * rest_flexibility(arc), 1, 1e-3)
            << arc_deg << " " << slenderness;
        EXPECT_NEAR(at->force_by_strain / solver.rest().force_by_strain, 1, 1e-3);
      }
    }
  }
}

TEST(HorseshoeEquilibrium, StraightArcOnlyStretches) {
  // Nearly straight, delta grows by sin(phi0)/phi0 per strain, E A sin(phi0)/phi0 in force.
  for (const double arc_deg : arcs_deg) {
    const Arc arc = arc_of(arc_deg, 1e-3);
    const ArcSolver solver(arc);
    const double pulled = full_extension(arc) + 0.5;
    const auto at = solver.advance(solver.rest(), pulled);
    ASSERT_TRUE(at);
    const double limit = std::sin(arc.half_angle_rad) / arc.half_angle_rad / arc.compliance;
    EXPECT_NEAR(at->force_by_strain / limit, 1, 2e-6) << arc_deg;
    EXPECT_NEAR(at->bent.force / (0.5 * limit), 1, 2e-6) << arc_deg;
  }
}

TEST(HorseshoeEquilibrium, AgreesWithShootingOverTheWholeRange) {
  for (const double arc_deg : arcs_deg) {
    for (const double slenderness : slendernesses) {
      const Arc arc = arc_of(arc_deg, slenderness);
      const ArcSolver solver(arc);
      const double full = full_extension(arc);
      for (const double strain :
           {-0.3, -0.1, -0.2 * full, 0.5 * full, 0.9 * full, full, full + 0.05, full + 0.5}) {
        SCOPED_TRACE(testing::Message() << "arc " << arc_deg << " degrees, w/R " << slenderness
                                        << ", strain " << strain);
        const auto at = solver.advance(solver.rest(), strain);
        ASSERT_TRUE(at);
        EXPECT_LT(solver.invariant_defect(*at), 1e-12);
        const double end_slope = solver.end_slope_rad(*at);
        const Shot shot = shoot_free_end(arc, at->bent.force, end_slope);
        const long double sine = std::sin(static_cast<long double>(arc.half_angle_rad));
        const auto strain_error = static_cast<double>(shot.half_chord / sine - 1 - strain);
        EXPECT_LT(std::abs(strain_error * at->force_by_strain / at->bent.force), 1e-10);
        EXPECT_NEAR(static_cast<double>(shot.end_slope) / end_slope, 1, 1e-9);
        EXPECT_NEAR(static_cast<double>(shot.end_rate), 1, 1e-11);
        EXPECT_LT(shot.drift, 1e-14L * (1 + std::abs(at->bent.force)));
      }
    }
  }
}

TEST(HorseshoeEquilibrium, OneWayOrTheOtherIsTheSame) {
  // One leap, small steps, and back from beyond: the branch does not depend on the way.
  for (const double slenderness : {1e-3, 0.3, 30.0}) {
    const Arc arc = arc_of(200, slenderness);
    const ArcSolver solver(arc);
    for (const double strain : {-0.25, 0.6 * full_extension(arc), full_extension(arc) + 0.2}) {
      const auto leap = solver.advance(solver.rest(), strain);
      auto walk = std::optional(solver.rest());
      for (int i = 1; i <= 50 && walk; ++i) walk = solver.advance(*walk, strain * i / 50);
      const auto beyond = solver.advance(solver.rest(), strain * 1.1);
      ASSERT_TRUE(leap && walk && beyond);
      const auto back = solver.advance(*beyond, strain);
      ASSERT_TRUE(back);
      EXPECT_NEAR(walk->bent.force / leap->bent.force, 1, 1e-11);
      EXPECT_NEAR(back->bent.force / leap->bent.force, 1, 1e-11);
    }
  }
}

TEST(HorseshoeEquilibrium, InvariantShowsAWrongArc) {
  // A bent arc that is no equilibrium of its force: the check must not pass everything.
  const Arc arc = arc_of(180, 0.5);
  const ArcQuadrature coarse(6);
  EXPECT_GT(coarse.invariant_defect(arc, {ArcChart::pendulum, 300, 0.8}), 1e-9);
  EXPECT_LT(ArcQuadrature(30).invariant_defect(arc, {ArcChart::pendulum, 300, 0.8}), 1e-12);
}

TEST(HorseshoeEquilibrium, DerivativesOfTheIntegrals) {
  const Arc arc = arc_of(160, 0.7);
  const ArcQuadrature quadrature(30);
  for (const BentArc& bent :
       {BentArc{ArcChart::slope, 0.4, 1.5}, BentArc{ArcChart::slope, -0.6, 1.9},
        BentArc{ArcChart::pendulum, 3.0, 0.6}, BentArc{ArcChart::pendulum, 400.0, 0.7},
        BentArc{ArcChart::pendulum, -0.9, 0.5}}) {
    const double step = 1e-5;
    const ArcIntegrals at = quadrature.integrals(arc, bent);
    const auto moved = [&](double force, double end) {
      return quadrature.integrals(arc, {bent.chart, bent.force + force, bent.end + end});
    };
    const ArcIntegrals more = moved(step, 0);
    const ArcIntegrals less = moved(-step, 0);
    const ArcIntegrals longer = moved(0, step);
    const ArcIntegrals shorter = moved(0, -step);
    EXPECT_NEAR(at.angle_by_force, (more.angle - less.angle) / (2 * step), 1e-8);
    EXPECT_NEAR(at.lag_by_force, (more.lag - less.lag) / (2 * step), 1e-8);
    EXPECT_NEAR(at.angle_by_end, (longer.angle - shorter.angle) / (2 * step), 1e-7);
    EXPECT_NEAR(at.lag_by_end, (longer.lag - shorter.lag) / (2 * step), 1e-7);
  }
}

TEST(HorseshoeEquilibrium, BothChartsSayTheSame) {
  const Arc arc = arc_of(150, 0.6);
  const ArcQuadrature quadrature(40);
  for (const BentArc& bent :
       {BentArc{ArcChart::pendulum, 2.0, 0.6}, BentArc{ArcChart::pendulum, -0.8, 0.4}}) {
    const BentArc other = rewritten(arc, bent, ArcChart::slope);
    const ArcIntegrals a = quadrature.integrals(arc, bent);
    const ArcIntegrals b = quadrature.integrals(arc, other);
    EXPECT_NEAR(a.angle, b.angle, 1e-13);
    EXPECT_NEAR(a.lag, b.lag, 1e-13);
    EXPECT_NEAR(rewritten(arc, other, ArcChart::pendulum).end, bent.end, 1e-13);
  }
}

}  // namespace
}  // namespace latticast
