// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre integrals along a pulled circular arc, from the first integral of its equation
// (docs/horseshoe.md#method).
#pragma once

#include <vector>

namespace latticast {

/// A circular arc with pinned ends, free of units. It is pulled along its chord by
/// beta = f R^2/(E I); delta = f/(E A) = compliance * beta.
struct Arc {
  double half_angle_rad = 0;  ///< phi0, 0 < phi0 < pi
  double compliance = 0;      ///< I/(A R^2) = (w/R)^2/12 for a rectangular strip, > 0
};

/// How a bent arc is written down. With z = sin^2(theta/2), theta the slope from the force line,
/// the first integral of theta'' = beta sin(theta)(1 + delta cos(theta)) with theta' = 1 at the end
/// reads
///     theta'^2 = 1 - W(theta_end) + W(theta),   W = kappa^2 z - 4 beta delta z^2,
///     kappa^2 = 4 beta (1 + delta).
enum class ArcChart {
  slope,    ///< the arc is walked by its slope; good while theta' does not vary much
  pendulum  ///< W = kappa^2 Q^2 turns it into a pendulum's, Q(v) = sinh(kappa v)/(kappa cosh(kappa
            ///< v_end)) (sin and cos when kappa^2 < 0), theta' = cosh(kappa v)/cosh(kappa v_end): v
            ///< is about half the arc's angle, and boundary layers are smooth in it. For theta_end
            ///< up to about 90 degrees and kappa^2 away from 0
};

/// One bent half of an arc: theta = 0 in the middle, theta' = 1 (no moment) at the end, theta' > 0.
/// Nothing says yet how long it is.
struct BentArc {
  ArcChart chart = ArcChart::slope;
  double force = 0;  ///< beta
  double end = 0;    ///< theta_end (slope) or v_end (pendulum)
};

/// What a bent arc amounts to, with derivatives by its two numbers.
struct ArcIntegrals {
  double angle = 0;  ///< integral of d alpha: the half angle that the arc had when it was a circle
  double angle_by_force = 0;
  double angle_by_end = 0;
  double lag = 0;  ///< (1 + delta) angle - (half chord)/R = integral of
                   ///< (1 - cos theta)(1 + delta (1 + cos theta)) d alpha
  double lag_by_force = 0;
  double lag_by_end = 0;
};

/// Gauss-Legendre quadrature along bent arcs. Where not a number comes back, no such arc exists.
class ArcQuadrature {
 public:
  explicit ArcQuadrature(int points);

  ArcIntegrals integrals(const Arc& arc, const BentArc& bent) const;

  /// How well the arc meets its differential equation: theta' at every quadrature point is computed
  /// a second time, as 1 - integral of theta'' from there to the end, and put into the invariant
  /// theta'^2 - 2 beta (-cos theta - delta cos^2 theta / 2). Returns the largest difference from
  /// its value at the end, over the largest theta'^2.
  double invariant_defect(const Arc& arc, const BentArc& bent) const;

 private:
  ArcIntegrals along_slope(const Arc& arc, const BentArc& bent) const;
  ArcIntegrals along_pendulum(const Arc& arc, const BentArc& bent) const;

  std::vector<double> points_;   // on (0, 1)
  std::vector<double> weights_;  // adding up to 1
  std::vector<double> to_end_;   // row i: integral from points_[i] to 1, by values at the points
};

/// sin^2(theta_end/2).
double end_sine_squared(const Arc& arc, const BentArc& bent);

/// The chart in which this arc is smoother, and the arc rewritten in it.
ArcChart better_chart(const Arc& arc, const BentArc& bent);
BentArc rewritten(const Arc& arc, const BentArc& bent, ArcChart chart);

}  // namespace latticast
