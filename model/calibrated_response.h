// SPDX-License-Identifier: GPL-3.0-or-later
// Response of a bonded section that a unit cell has calibrated: corrected to one state under
// pressure where that is asked for, and handed over to the cell where no correction reaches
// (docs/bonded.md#calibration).
#pragma once

#include <span>

#include "model/equilibrium/response.h"
#include "model/prepared_segment.h"

namespace latticast {

/// The section's response; states that hold more than three times the cavity's volume at rest, are
/// unstable or do not exist, limit points and bifurcations are the cell's own, and the message says
/// from where on: no pressure at which a branch ends is the section's. Where a state is calibrated
/// as well, the message says by how much that moved it. Preconditions: the segment is calibrated,
/// pressures are finite.
Response calibrated_response(const PreparedSegment& segment, std::span<const double> pressures_kpa,
                             Held held, const SolverOptions& options);

}  // namespace latticast
