// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cell of one even family of straight strips with evenly pitched rings: half of one strip by
// one ring pitch, meshed by hexahedra that follow the strip.
#pragma once

#include "model/cell/cell_mesh.h"
#include "model/cell/strip_tube.h"

namespace latticast {

/// Elements along each way through the cell.
struct StripDivision {
  int strip = 1;       ///< across a strip
  int gap = 3;         ///< across a gap
  int ring = 1;        ///< along half a ring
  int span = 2;        ///< along half of what is between rings
  int liner = 3;       ///< through the liner
  int lattice = 1;     ///< through the layer; 0: no lattice, a bare tube
  double grading = 1;  ///< how many times as long the elements in the middle of a gap and of a
                       ///< span, and at the bore, are as those at the lattice
  bool whole = false;  ///< one whole pitch, as a check of the half
};

/// Half a turn about the radial axis through a crossing of strip and ring maps the tube onto
/// itself, and so does one about the strip's axis half a pitch further: the cell is what lies
/// between both. Precondition: strips and rings leave gaps; 0 < angle < pi.
CellMesh strip_cell(const StripTube& tube, const StripDivision& division);

}  // namespace latticast
