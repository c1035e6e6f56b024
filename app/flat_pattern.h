// SPDX-License-Identifier: GPL-3.0-or-later
// A segment's lattice as a drawing to cut a sheet by.
#pragma once

#include <string>

#include "design/design.h"
#include "export/flat/flat_drawing.h"
#include "geometry/solid/flat_pattern.h"

namespace latticast {

/// The sheet of one segment with its title and notes. `sheet` is flat_pattern() of that segment.
FlatDrawing flat_drawing(const Design& design, std::size_t segment, const FlatPattern& sheet);

/// For people: "106.814 mm around (R = 17 mm), 85 mm along, 1 piece with 44 holes, within 0.01 mm
/// of what was drawn".
std::string describe(const FlatPattern& sheet);

}  // namespace latticast
