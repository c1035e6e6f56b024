// SPDX-License-Identifier: GPL-3.0-or-later
// Where around the tube a grid's strands have to be looked at.
#pragma once

#include <vector>

#include "design/design.h"
#include "model/equilibrium/state.h"

namespace latticast {

/// A strand of this width at a place around the tube, at its segment's base.
struct StrandStation {
  int strand = 0;
  double theta_rad = 0;
  double width_mm = 0;
};

/// Each strand where it sits, as long as the grid winds with the bending; otherwise every strand
/// meets all sides, and the first of each width stands on the lengthened and the shortened one.
std::vector<StrandStation> strand_stations(const Segment& segment, const Grid& grid,
                                           const State& state);

}  // namespace latticast
