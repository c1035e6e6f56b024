// SPDX-License-Identifier: GPL-3.0-or-later
// Segments as the design file gives them: liner, rings, grids, and the rules that hold between
// them.
#pragma once

#include <vector>

#include "design/design.h"
#include "design/material_library.h"
#include "design/table_reader.h"

namespace latticast {

/// Reads the list [[segment]]. The column model decides which laws a liner may have. Numbers that
/// were refused are NaN in the result; a segment has a lattice when one is written, right or wrong.
std::vector<Segment> read_segments(const Field& field, const MaterialLibrary& library,
                                   ColumnModel columns);

}  // namespace latticast
