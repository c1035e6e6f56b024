// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a printer can make the lattice: widths and gaps where they are smallest, loose parts,
// overhangs, bridges, the bed.
#pragma once

#include "checks/check_finding.h"
#include "design/design.h"

namespace latticast {

class PreparedLattices;

/// What a process prints without supports, from common design rules (docs/checks.md).
struct FreePrinting {
  double least_slope_deg = 0;  ///< from the bed
  double longest_bridge_mm = 0;
};
FreePrinting free_printing(Process process);

/// The slope from the bed of a family's strands in an upright print, at the outer radius, where it
/// is least; of horseshoes the slope of their flattest piece.
double least_slope_deg(const Segment& segment, const Grid& grid);

/// Checks of what `[make]` asks to be printed (lattice_use.h), and of the lattice in the grooves of
/// its mold. A lattice that is to be drawn and cannot be gets cannot-draw, and no checks of what
/// would be drawn; one that is only predicted (columns = "rods") may be anything.
/// `lattices` are those of the design, or of one with the same segments.
CheckFindings print_checks(const Design& design, PreparedLattices& lattices);

}  // namespace latticast
