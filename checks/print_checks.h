// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a printer can make the lattice: widths and gaps where they are smallest, loose parts,
// overhangs, bridges, the bed.
#pragma once

#include "checks/check_finding.h"
#include "spec/design.h"

namespace latticast {

/// The printer's smallest sizes, as the design states them or as its process is commonly given:
/// fdm 0.8 mm walls (two lines of a 0.4 mm nozzle) and 0.4 mm gaps; sla 0.4 mm and 0.2 mm.
double least_wall_mm(const Printer& printer);
double least_gap_mm(const Printer& printer);

/// Checks of what `[make]` asks to be printed. Where the lattice is cast instead, its strands are
/// the grooves of the mold, and its gaps the mold's lands: the limits change places.
CheckFindings print_checks(const Design& design);

}  // namespace latticast
