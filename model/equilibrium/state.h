// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium state of a segment: its coordinates, reactions, and how far to trust it.
#pragma once

#include <array>

#include "model/section/deformation.h"

namespace latticast {

/// Coordinates held at their rest value by the mounting; each one's reaction is then in the State.
struct Held {
  bool twist = false;    ///< k = 0: the reaction is the blocked torque
  bool stretch = false;  ///< lambda = 1: the reaction is the blocked force
  bool bend = false;     ///< kappa = 0: the reaction is the blocked moment
};

/// One equilibrium, with the numbers that say how far to trust it.
/// Scaled coordinates are (lambda, k R_o, kappa R_o, a/R_i); the energy unit is G A, the liner's
/// shear modulus at rest times the rubber's cross-section area.
struct State {
  double pressure_kpa = 0;
  double stretch = 1;           ///< lambda
  double twist_rad_per_mm = 0;  ///< k, per reference length, right-handed about +z; the paper's
                                ///< tau is k / lambda, the end rotation k L
  /// kappa at the segment's base, per reference length, by its components toward Theta = 0 and
  /// Theta = 90 degrees: that side lengthens, the tube bends the other way. Its direction turns
  /// along the segment with `frame_turn_rad_per_mm`, Z and Theta being those of the material.
  std::array<double, 2> bend_rad_per_mm{};
  double frame_turn_rad_per_mm = 0;
  double inner_radius_mm = 0;          ///< a
  double outer_radius_mm = 0;          ///< r(R_o)
  double torque_nmm = 0;               ///< dPi/dk, applied by the mounting; 0 when twist is free
  std::array<double, 2> moment_nmm{};  ///< dPi/dkappa by the same components, applied by the
                                       ///< mounting; 0 when bending is free
  double force_n = 0;              ///< dPi/dlambda, applied by the mounting; 0 when stretch is free
  double residual = 0;             ///< largest scaled entry of the free gradient, in units of
                                   ///< G A + |P| pi R_i^2
  double error_estimate = 0;       ///< largest error of a scaled coordinate: twice the gradient
                                   ///< under a finer quadrature, Newton residual included, and what
                                   ///< interpolated laws and rounding add, mapped by H^-1
  double smallest_eigenvalue = 0;  ///< of the scaled free Hessian, in units of G A
  bool stable = false;             ///< smallest_eigenvalue > 0
  double time_us = 0;              ///< solver time since the previous state
  int iterations = 0;              ///< Newton iterations since the previous state

  /// |kappa|: the far end of a segment of length L is turned by this times L.
  double bend_magnitude_rad_per_mm() const;

  /// Theta in [0, 2 pi) toward which the segment bends at its base, that of -kappa; 0 when
  /// straight.
  double bend_direction_rad() const;

  /// The same state in the coordinates of a section with the given first axis.
  Deformation deformation(double rest_inner_radius_mm, double axis_rad = 0) const;
};

}  // namespace latticast
