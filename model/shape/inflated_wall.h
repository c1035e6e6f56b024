// SPDX-License-Identifier: GPL-3.0-or-later
// Deformation gradient in the wall of an inflated segment.
#pragma once

#include "design/design.h"
#include "model/equilibrium/state.h"

namespace latticast {

/// The deformation gradient at one place of the wall, around and along the tube
/// (docs/model.md#coordinates): F = [hoop, shear; 0, axial], incompressible across the wall.
struct WallStretch {
  double radius_mm = 0;  ///< current
  double hoop = 1;       ///< r/R
  double axial = 1;      ///< Lambda
  double shear = 0;      ///< k r

  double across() const { return 1 / (hoop * axial); }

  /// I1 - 3 of the rubber; 0 or more.
  double first_invariant_minus_3() const;

  /// The largest of the three principal stretches.
  double largest_principal() const;

  /// The larger and the smaller of the two principal stretches in the wall.
  double largest_in_wall() const;
  double least_in_wall() const;

  /// |F A| of a strand that rests at `angle_rad` from the circumference.
  double along(double angle_rad) const;

  /// Angle from the circumference, 0 to pi, at which that strand now lies.
  double turned_rad(double angle_rad) const;
};

/// At reference radius R >= R_i on the side of Theta, both of the segment's base.
WallStretch wall_stretch(const Segment& segment, const State& state, double reference_radius_mm,
                         double theta_rad);

/// Theta of the side that bending lengthens most; 0 when straight. The opposite side is shortened.
double lengthened_side_rad(const State& state);

}  // namespace latticast
