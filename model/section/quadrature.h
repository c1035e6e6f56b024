// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature over a cross-section: Gauss-Legendre points in R, the trapezoidal rule around the
// tube.
#pragma once

#include <vector>

#include "model/section/section.h"

namespace latticast {

/// Radii and weights of an integral over the wall, 2 pi R dR included in the weight.
struct QuadraturePoint {
  double radius_mm = 0;
  double weight_mm2 = 0;
};

/// A direction in the section and its share of the whole turn.
struct Direction {
  double cosine = 1;
  double sine = 0;
  double weight = 1;
};

/// Points of a section's integrals: Gauss-Legendre in R, trapezoidal around the tube. `lattice` is
/// empty without a lattice. `average_strands`: all families are averaged around the tube.
struct Quadrature {
  std::vector<QuadraturePoint> liner;
  std::vector<QuadraturePoint> lattice;
  std::vector<Direction> around;
  bool average_strands = false;
};

/// Points for a section's integrals, `liner_points` >= 1 and `lattice_points` >= 1 of them in R,
/// and `around` >= 1 directions evenly spaced around the whole tube. Integrals that begin at the
/// bore are cut into `bore_panels` >= 1 parts, each with that many points and a quarter as thick as
/// the next one outwards: for states whose bore is nearly closed.
Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points,
                           int around = 24, int bore_panels = 1);

/// Panels that a state needs. Gauss points converge slowly when the energy is singular close below
/// R_i: r(R) is zero where R^2 = R_i^2 - lambda a^2, and a Gent rubber that is near its limit at
/// the bore would reach it a little inside. The innermost panel is not thicker than that distance,
/// as far as it is known. 1 where it is more than a twentieth of the wall. Precondition: the state
/// can exist.
int bore_panels_for(const Section& section, const Deformation& at);

/// Directions evenly spaced on half of the tube, from the first axis to its opposite, each
/// standing for its mirror image as well: `intervals` >= 1 of them.
std::vector<Direction> half_turn(int intervals);

}  // namespace latticast
