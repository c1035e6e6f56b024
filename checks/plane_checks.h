// SPDX-License-Identifier: GPL-3.0-or-later
// What only the united lattice shows: cells that close, slivers where strands graze, loose parts,
// bridges.
#pragma once

#include "checks/check_finding.h"
#include "checks/lattice_plane.h"
#include "checks/lattice_use.h"
#include "design/design.h"

namespace latticast {

/// The lattice of one segment, drawn and united once for all checks.
struct UnitedLattice {
  const Segment& segment;
  int number = 0;  ///< of the segment, from 1
  LatticePlane plane;
};

/// How long the wedge of a corner is narrower than `width_mm`: the way from the corner along both
/// its sides, as far as points at equal ways are nearer to each other. For straight sides that
/// meet at the angle d it is width / (2 sin(d/2)). 0 for corners of the material, and for blunt
/// ones (90 degrees and more); at most half of the outline. `stretch` is applied to u.
double wedge_length_mm(const Outline& outline, std::size_t corner, double width_mm, double stretch);

/// cell-too-small, acute-corner, loose-part: the worst place of each code, but every loose part up
/// to the eighth. Cells are not looked at without `gaps_are_wide`: where whole gaps are too small,
/// every opening between the strands is.
CheckFindings plane_checks(const UnitedLattice& lattice, const LatticeUse& use,
                           bool gaps_are_wide = true);

/// The longest level underside between two supports in printing position (z up), as long as it is
/// at the outer radius; what stands on z = 0 is supported.
struct Bridge {
  double length_mm = 0;
  PlanePoint middle;
};
Bridge longest_bridge(const UnitedLattice& lattice);

/// A point of the plane around the tube, 0 <= theta < 360.
CheckPlace place_of(const UnitedLattice& lattice, PlanePoint point);

}  // namespace latticast
