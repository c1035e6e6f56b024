// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges of any lattice: the plane's triangulation swept through liner and lattice, as the unit
// cell of one period, or from end to end for finite-element programs.
#pragma once

#include "design/design.h"
#include "geometry/mesh/wedge_mesh.h"
#include "geometry/solid/period_mesh.h"
#include "model/cell/cell_mesh.h"

namespace latticast {

/// Elements through the wall.
struct SweptDivision {
  int liner = 3;
  int lattice = 1;
  double grading =
      1;  ///< how many times as thick the element at the bore is as that at the lattice
};

/// `repeats` of the cell fill the tube's circumference; where it is 1, the tube may bend. Ends that
/// are mirrors do not move along the tube.
struct SweptPeriod {
  int repeats = 1;
  bool mirrored = false;
};

/// Precondition: the liner is a rubber, the lattice linear; the plane was unrolled at the lattice's
/// mid radius.
CellMesh swept_cell(const Segment& segment, const PeriodMesh& plane, const SweptPeriod& period,
                    const SweptDivision& division);

/// The segment from end to end, or one of its equal `sectors`: the plane holds that much of it, its
/// sides alike. Precondition as above.
WedgeMesh swept_wedges(const Segment& segment, const PeriodMesh& plane, int sectors,
                       const SweptDivision& division);

}  // namespace latticast
