// SPDX-License-Identifier: GPL-3.0-or-later
// Strand paths as the design file gives them: the key of a [[segment.lattice.grid]] that names the
// path, with its table of sizes.
#pragma once

#include "design/design.h"
#include "design/table_reader.h"

namespace latticast {

/// Reads the one path key of a grid's table; a straight path without any. Two of them are refused.
/// Numbers that were refused are NaN in the result. The segment and the grid's angle are known;
/// limits::arcs bounds the links of a strand.
StrandPath read_strand_path(TableReader& table, const Segment& segment, double angle_deg);

}  // namespace latticast
