// SPDX-License-Identifier: GPL-3.0-or-later
// Blocked tip force of a bending segment, [Wang] Fig. 10(a), as a planar rod in equilibrium
// (docs/bending.md#held-bending-and-the-tip-force).
#pragma once

#include <optional>

#include "model/prepared_segment.h"

namespace latticast {

/// Base clamped; the tip meets a stop that keeps it from moving sideways, but lets it turn and
/// slide along the base's axis without friction.
struct TipForce {
  double force_n = 0;          ///< that the stop applies, square to the base's axis; >= 0
  double tip_turn_rad = 0;     ///< of the tip's section, positive toward the free bending
  double base_moment_nmm = 0;  ///< that the stop makes at the base; >= 0
  double tip_height_mm = 0;    ///< of the tip over the base
};

/// The stop's force at a pressure. kappa varies along the segment: each section is in equilibrium
/// under the stop's moment and axial share (docs/model.md#energy, with M and N), and the centre
/// line is a planar rod of any deflection without shear. Integrated from the tip in 64 Runge-Kutta
/// steps (error below 1e-7 of the force where kappa L < 2); tip angle and force by Newton's method.
/// For weak bending the force is 3 EI kappa/(2 L). Empty where the free segment has no stable
/// equilibrium or the constrained one was not found; 0 for a segment that does not bend. Throws
/// UnsupportedDesign for a section that twists or has no mirror plane: its constrained shape is not
/// planar.
std::optional<TipForce> blocked_tip_force(const PreparedSegment& segment, double pressure_kpa);

}  // namespace latticast
