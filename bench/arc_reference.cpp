// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/arc_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/long_gauss.h"
#include "tests/unit/model/horseshoe/horseshoe_shooting.h"

namespace latticast {
namespace {

using Real = long double;

// The arc's two numbers: beta, and log m with m = theta'^2 in the middle.
struct Unknowns {
  Real force;
  Real log_middle;
};

struct Mismatch {
  Real angle;
  Real strain;
};

Real potential(Real beta, Real delta, Real z) {
  return 4 * beta * z * (1 + delta * (1 - z));
}

// z = sin^2(theta_end/2), where W(z) = 1 - m.
Real end_of(Real beta, Real delta, Real middle) {
  const Real rise = 4 * beta * (1 + delta);
  const Real curving = 4 * beta * delta;
  const Real root = std::sqrt(rise * rise - 4 * curving * (1 - middle));
  return 2 * (1 - middle) / (rise + (rise > 0 ? root : -root));
}

// theta by a variable in which boundary layers are smooth, and its rate.
struct Slope {
  Real theta;
  Real by_s;
};

// Pulled: theta = width sinh s. Pushed: sin(theta/2) = width/2 sin s.
struct Chart {
  bool pulled;
  Real width;

  Real reach(Real end) const {
    return pulled ? std::asinh(end / width) : std::asin(2 * std::sin(end / 2) / width);
  }

  Slope at(Real s) const {
    if (pulled) return {width * std::sinh(s), width * std::cosh(s)};
    const Real half_sine = width / 2 * std::sin(s);
    return {2 * std::asin(half_sine),
            width * std::cos(s) / std::sqrt((1 - half_sine) * (1 + half_sine))};
  }
};

Mismatch mismatch(const Arc& arc, Real strain, const Unknowns& at) {
  static const LongGaussRule rule = long_gauss(30);
  const Real beta = at.force;
  const Real delta = beta * arc.compliance;
  const Real middle = std::exp(at.log_middle);
  const Real end = 2 * std::asin(std::sqrt(end_of(beta, delta, middle)));
  const Chart chart{beta > 0, std::sqrt(middle / std::abs(beta * (1 + delta)))};
  const Real reach = chart.reach(end);
  const int panels = 6 + static_cast<int>(std::ceil(reach));
  Real angle = 0;
  Real chord = 0;
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const Slope slope = chart.at(reach * (panel + (1 + rule.points[i]) / 2) / panels);
      const Real half_sine = std::sin(slope.theta / 2);
      const Real z = half_sine * half_sine;
      const Real along = reach / panels * rule.weights[i] / 2 * slope.by_s /
                         std::sqrt(middle + potential(beta, delta, z));
      angle += along;
      chord += along * (1 - 2 * z) * (1 + delta * (1 - 2 * z));
    }
  }
  return {angle - arc.half_angle_rad, chord / std::sin(Real{arc.half_angle_rad}) - 1 - strain};
}

Unknowns start_from(const Arc& arc, const ArcEquilibrium& near) {
  const Real beta = near.bent.force;
  const Real delta = beta * arc.compliance;
  const Real middle = 1 - potential(beta, delta, end_sine_squared(arc, near.bent));
  const Real growth = std::sqrt(std::abs(beta * (1 + delta))) * arc.half_angle_rad;
  // A small m is a difference of large numbers; then the arc is nearly straight.
  const Real layer = -2 * (growth + std::log((1 + std::exp(-2 * growth)) / 2));
  return {beta, middle > 0.01L ? std::log(middle) : layer};
}

// Newton's method with differences for derivatives: rounding is 1e-19, so that they are good
// to about 1e-9 and every step gains as many digits.
Unknowns solved(const Arc& arc, Real strain, Unknowns at) {
  for (int step = 0; step < 30; ++step) {
    const Mismatch here = mismatch(arc, strain, at);
    const Real by_force = 1e-9L * std::abs(at.force);
    const Real by_middle = 1e-9L;
    const Mismatch f = mismatch(arc, strain, {at.force + by_force, at.log_middle});
    const Mismatch m = mismatch(arc, strain, {at.force, at.log_middle + by_middle});
    const Real a = (f.angle - here.angle) / by_force;
    const Real b = (m.angle - here.angle) / by_middle;
    const Real c = (f.strain - here.strain) / by_force;
    const Real d = (m.strain - here.strain) / by_middle;
    const Real force_step = (here.angle * d - here.strain * b) / (a * d - b * c);
    at.force -= force_step;
    at.log_middle -= (here.strain * a - here.angle * c) / (a * d - b * c);
    if (std::abs(force_step) < 1e-17L * std::abs(at.force)) break;
  }
  return at;
}

// Strain of the arc that Taylor series shoot, by the force.
Real shot_strain(const Arc& arc, double force, double end_slope) {
  return shoot_free_end(arc, force, end_slope).half_chord / std::sin(Real{arc.half_angle_rad}) - 1;
}

// The force whose arc has the strain, by its slope at `near`.
Real shot_force(const Arc& arc, const ArcEquilibrium& near) {
  const double z = end_sine_squared(arc, near.bent);
  const double end_slope = 2 * std::asin(std::sqrt(z));
  double force = near.bent.force;
  Real correction = 0;
  for (int step = 0; step < 4; ++step) {
    correction = (near.strain - shot_strain(arc, force, end_slope)) * near.force_by_strain;
    if (std::abs(correction) < 1e-15L * std::abs(force)) break;
    force += static_cast<double>(correction);
  }
  return force + correction;
}

}  // namespace

long double arc_reference_force(const Arc& arc, const ArcEquilibrium& near) {
  return solved(arc, near.strain, start_from(arc, near)).force;
}

ArcReference arc_reference(const Arc& arc, const ArcEquilibrium& near) {
  const Real first = arc_reference_force(arc, near);
  const Real second = shot_force(arc, near);
  const Real apart = std::abs(second / first - 1);
  return {first, std::isfinite(apart) ? apart : std::numeric_limits<Real>::infinity()};
}

}  // namespace latticast
