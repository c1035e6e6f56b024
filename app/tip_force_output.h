// SPDX-License-Identifier: GPL-3.0-or-later
// The force of each segment against a stop at its tip (docs/command-line.md).
#pragma once

#include <vector>

#include "app/number_rows.h"
#include "design/design.h"

namespace latticast {

struct TipForceAnswer {
  NumberRows numbers;    ///< one row a segment and pressure
  bool complete = true;  ///< false: some pressure has no stable equilibrium, its row is missing
};

/// `pressures_kpa`, when not empty, replaces the design's load. Throws UnsupportedDesign for a
/// segment whose constrained shape is not planar, std::invalid_argument without any pressure.
TipForceAnswer predict_tip_forces(const Design& design, const std::vector<double>& pressures_kpa);

}  // namespace latticast
