// SPDX-License-Identifier: GPL-3.0-or-later
// The wall as its unit cell shows it: `latticast predict --wall`.
#pragma once

#include <vector>

#include "app/number_rows.h"
#include "design/design.h"

namespace latticast {

/// A row a segment and pressure: bulge, largest strains, traction on the bond (CellWall). Throws
/// UnsupportedDesign where a segment is predicted without a unit cell, std::invalid_argument when
/// there is no load at all.
NumberRows predict_walls(const Design& design, const std::vector<double>& pressures_kpa);

}  // namespace latticast
