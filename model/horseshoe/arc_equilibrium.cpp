// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/arc_equilibrium.h"

#include <algorithm>
#include <cmath>

#include "model/law/link_steps.h"

namespace latticast {
namespace {

constexpr int most_arc_iterations = 8;
constexpr double strain_rounding = 1e-15;

// Derivatives of the residuals (angle, strain) by (force, end).
struct Jacobian {
  double angle_by_force, angle_by_end, strain_by_force, strain_by_end;

  double determinant() const {
    return angle_by_force * strain_by_end - angle_by_end * strain_by_force;
  }
};

struct Residual {
  double angle, strain;
  Jacobian jacobian;
};

Residual residual_of(const ArcQuadrature& quadrature, const Arc& arc, double sine,
                     const BentArc& bent, double strain) {
  const ArcIntegrals sum = quadrature.integrals(arc, bent);
  const double straight = (1 + arc.compliance * bent.force) * arc.half_angle_rad;
  return {
      sum.angle - arc.half_angle_rad,
      (straight - sum.lag) / sine - 1 - strain,
      {sum.angle_by_force, sum.angle_by_end,
       (arc.compliance * arc.half_angle_rad - sum.lag_by_force) / sine, -sum.lag_by_end / sine}};
}

}  // namespace

ArcSolver::ArcSolver(const Arc& arc, int quadrature_points)
    : arc_(arc), sine_(std::sin(arc.half_angle_rad)), quadrature_(quadrature_points) {
  const double phi = arc.half_angle_rad;
  const double bending = phi * (2 + std::cos(2 * phi)) - 1.5 * std::sin(2 * phi);
  const double stretching = arc.compliance * (phi + std::sin(2 * phi) / 2);
  rest_.bent = {ArcChart::slope, 0, phi};
  rest_.force_by_strain = 2 * sine_ / (bending + stretching);
  const Jacobian by = residual_of(quadrature_, arc, sine_, rest_.bent, 0).jacobian;
  rest_.end_by_strain = by.angle_by_force / by.determinant();
}

std::optional<ArcEquilibrium> ArcSolver::corrected(BentArc bent, double strain) const {
  const double force_rounding = strain_rounding * rest_.force_by_strain;
  bool nearly_there = false;
  for (int iteration = 0; iteration < most_arc_iterations; ++iteration) {
    const Residual at = residual_of(quadrature_, arc_, sine_, bent, strain);
    const Jacobian& by = at.jacobian;
    const double determinant = by.determinant();
    const double force_step =
        (at.angle * by.strain_by_end - at.strain * by.angle_by_end) / determinant;
    const double end_step =
        (at.strain * by.angle_by_force - at.angle * by.strain_by_force) / determinant;
    bent.force -= force_step;
    bent.end -= end_step;
    if (!std::isfinite(bent.force) || !(bent.end > 0)) return {};
    if (nearly_there) {
      return ArcEquilibrium{strain, bent, -by.angle_by_end / determinant,
                            by.angle_by_force / determinant};
    }
    nearly_there = std::abs(force_step) <= small_step * std::abs(bent.force) + force_rounding &&
                   std::abs(end_step) <= small_step * bent.end;
  }
  return {};
}

bool ArcSolver::small_correction(const ArcEquilibrium& from, const BentArc& guess,
                                 const BentArc& found) const {
  const double force_scale =
      std::max({std::abs(found.force), std::abs(from.bent.force), 1e-3 * from.force_by_strain});
  return std::abs(found.force - guess.force) <= largest_correction * force_scale &&
         std::abs(found.end - guess.end) <= largest_correction * guess.end;
}

std::optional<ArcEquilibrium> ArcSolver::step(const ArcEquilibrium& here, double strain) const {
  const double length = strain - here.strain;
  const BentArc guess{here.bent.chart, here.bent.force + here.force_by_strain * length,
                      here.bent.end + here.end_by_strain * length};
  std::optional<ArcEquilibrium> found = corrected(guess, strain);
  if (!found || !small_correction(here, guess, found->bent)) return {};
  const ArcChart chart = better_chart(arc_, found->bent);
  if (chart != found->bent.chart) found = corrected(rewritten(arc_, found->bent, chart), strain);
  return found;
}

std::optional<ArcEquilibrium> ArcSolver::advance(const ArcEquilibrium& from, double strain) const {
  return advance_link(from, strain,
                      [this](const ArcEquilibrium& here, double next) { return step(here, next); });
}

double ArcSolver::invariant_defect(const ArcEquilibrium& at) const {
  return quadrature_.invariant_defect(arc_, at.bent);
}

double ArcSolver::end_slope_rad(const ArcEquilibrium& at) const {
  return 2 * std::asin(std::sqrt(end_sine_squared(arc_, at.bent)));
}

}  // namespace latticast
