// SPDX-License-Identifier: GPL-3.0-or-later
// Extensible elastica of a circular arc pulled or pushed at its pinned ends: Newton's method along
// the branch from rest ([Wang] Appendix C; docs/horseshoe.md#equation). Free of units.
#pragma once

#include <optional>

#include "model/horseshoe/arc_integrals.h"

namespace latticast {

/// One equilibrium. strain = chord / rest chord - 1.
struct ArcEquilibrium {
  double strain = 0;
  BentArc bent;  ///< bent.force is beta, positive when pulled
  double force_by_strain = 0;
  double end_by_strain = 0;  ///< d bent.end / d strain
};

/// Solves theta'' = beta sin(theta)(1 + delta cos(theta)), theta(0) = 0, theta'(phi0) = 1 for a
/// given strain, along the branch that starts at rest. All arcs on that branch have theta' > 0:
/// where theta' first vanished, theta'' would vanish too, and theta were constant. So each of them
/// is a BentArc, and two equations are left for its two numbers: the half angle is phi0, the half
/// chord is (1 + strain) sin phi0. Wavy arcs cannot come up at all, looped ones only by a jump, and
/// a step whose correction is not small is repeated in halves.
class ArcSolver {
 public:
  /// Enough Gauss points for rounding-level integrals over the whole certified range of arcs.
  static constexpr int default_points = 26;

  /// Precondition: 0 < half angle < pi, compliance > 0, quadrature_points >= 1; fewer points than
  /// the default cost accuracy.
  explicit ArcSolver(const Arc& arc, int quadrature_points = default_points);

  /// The circle itself: strain and force 0, slope by the closed form
  ///     2 sin phi0 / (phi0 (2 + cos 2 phi0) - 1.5 sin 2 phi0 + c (phi0 + sin(2 phi0)/2)).
  const ArcEquilibrium& rest() const { return rest_; }

  /// Follows the branch from an equilibrium on it to `strain`. Empty when the branch cannot be
  /// followed that far: it turns back, or no arc exists.
  std::optional<ArcEquilibrium> advance(const ArcEquilibrium& from, double strain) const;

  /// Largest violation of the invariant along the arc, see ArcQuadrature.
  double invariant_defect(const ArcEquilibrium& at) const;

  /// theta at the end, rad.
  double end_slope_rad(const ArcEquilibrium& at) const;

  const Arc& arc() const { return arc_; }

 private:
  std::optional<ArcEquilibrium> step(const ArcEquilibrium& here, double strain) const;
  std::optional<ArcEquilibrium> corrected(BentArc bent, double strain) const;
  bool small_correction(const ArcEquilibrium& from, const BentArc& guess,
                        const BentArc& found) const;

  Arc arc_;
  double sine_;  // of the half angle
  ArcQuadrature quadrature_;
  ArcEquilibrium rest_;
};

}  // namespace latticast
