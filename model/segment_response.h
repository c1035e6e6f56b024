// SPDX-License-Identifier: GPL-3.0-or-later
// Response of a segment to pressure: equilibrium states by continuation from rest, how good each
// one is, and where the branch ends (docs/model.md#how-it-is-solved-and-how-good-a-state-is).
#pragma once

#include <span>

#include "design/design.h"
#include "model/equilibrium/response.h"
#include "model/prepared_segment.h"

namespace latticast {

/// Follows the equilibrium from the rest state to every requested pressure (kPa; any order,
/// duplicates, zero and suction allowed) and never jumps to another branch: a step counts only if
/// its correction is small against it. A pressure beyond a limit point has no state; the others are
/// still given. With effective rods the equilibrium is unique
/// (model/effective_rods/rods.h). Equations: dPi/dq = 0 with Pi = stored energy - P pi (a^2 lambda
/// - R_i^2), closed ends. Throws std::invalid_argument for a pressure that is not finite,
/// std::runtime_error when the solver library cannot be set up.
Response predict(const PreparedSegment& segment, std::span<const double> pressures_kpa,
                 Held held = {}, const SolverOptions& options = {});

/// Prepares the segment and predicts.
Response predict(const Segment& segment, const ModelChoice& model,
                 std::span<const double> pressures_kpa, Held held = {},
                 const SolverOptions& options = {});

}  // namespace latticast
