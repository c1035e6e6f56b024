// SPDX-License-Identifier: GPL-3.0-or-later
// The turned pieces that every mold has: the core, and the end plates that centre core and shell.
#pragma once

#include <vector>

#include "molds/mold_piece.h"

namespace latticast {

/// A rod standing on z = from, its upper and lower rim chamfered so that it finds its socket.
struct Core {
  double radius_mm = 0;
  double from_mm = 0;
  double to_mm = 0;
  double chamfer_mm = 1;
};

Solid core_solid(const Core& core, double tolerance_mm);

/// A round plate that holds a core's end in a socket and a shell's end in a rim: one piece, so that
/// both are centred by the same datum. Heights are measured from the face on which the shell
/// stands, away from the cavity (downwards for a base, upwards for a cap): the rim reaches `rim_mm`
/// over the shell, the socket is `socket_mm` deep, and `floor_mm` of plate lie behind it.
struct EndPlate {
  double core_radius_mm = 0;   ///< 0: no socket
  double hole_radius_mm = 0;   ///< of a round hole through the middle of a plate without socket
  double shell_radius_mm = 0;  ///< outside of the shell
  double rim_mm = 6;
  double socket_mm = 5;
  double floor_mm = 4;
  double wall_mm = 5;       ///< of the rim
  double clearance_mm = 0;  ///< on the diameter, of socket and rim
  /// Openings through the plate, for pouring and for air: windows of the annulus between two radii,
  /// both inside of the shell. An inner radius within the socket lets the windows open into it;
  /// the lands between them then hold the core.
  double opening_from_mm = 0;
  double opening_to_mm = 0;
  std::vector<double> openings_rad;  ///< middles
  double opening_width_rad = 0;
};

/// The base stands under the face z = face_mm, the cap above it (`upwards`).
Solid end_plate_solid(const EndPlate& plate, double face_mm, bool upwards, double tolerance_mm);

}  // namespace latticast
