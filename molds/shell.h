// SPDX-License-Identifier: GPL-3.0-or-later
// The grooved shell of a lattice mold: three radial layers cut by the drawn lattice, the seams, the
// bores and the straps.
#pragma once

#include <optional>
#include <vector>

#include "geometry/solid/tube_solids.h"
#include "molds/fill.h"
#include "molds/parting.h"

namespace latticast {

/// A level groove around the outside, for a strap or a hose clamp.
struct StrapGroove {
  double from_mm = 0;
  double to_mm = 0;
};

/// Everything that the shell's pieces have in common. The plane is the lattice's, with lands before
/// and behind it: all heights are from the shell's lower end.
struct Shell {
  Pattern lattice;  ///< shifted up by the land; its length is the shell's
  Parting parting;
  std::vector<Bore> bores;
  std::vector<StrapGroove> straps;
  CastLayer cast;              ///< the core's radius, and the bottom of the grooves
  double strap_radius_mm = 0;  ///< bottom of the strap grooves
  double outer_radius_mm = 0;
  double clearance_mm = 0;  ///< across every seam at the lattice's mid radius, and on the core's
                            ///< diameter
  double start_z_mm = 0;    ///< of the shell's lower end
  std::optional<double> closed_for_mm;  ///< tolerance for which `lattice` is closed
};

/// What a piece covers, drawn in the plane: its sector, half the clearance back from both seams.
Strand drawn_piece(const Shell& shell, int piece);

/// The shell with its lattice closed where it touches itself in points, once for all pieces of this
/// tolerance. Throws GeometryError.
Shell with_closed_lattice(Shell shell, double tolerance_mm);

/// One piece, in one part. Throws GeometryError as layered_solid does.
Solid shell_solid(const Shell& shell, int piece, double tolerance_mm);

}  // namespace latticast
