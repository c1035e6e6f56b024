// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetry of a cross-section: the frame in which it is the same at every height, and the
// coordinates that are zero by symmetry (docs/bending.md#distributed-columns).
#pragma once

#include "design/design.h"
#include "model/section/section.h"

namespace latticast {

/// Sets the frame, the symmetry flags and the strands' places of a section whose families are the
/// segment's grids with strands, in their order. Throws UnsupportedDesign for two uneven families
/// that wind at different rates.
void settle_symmetry(const Segment& segment, const ModelChoice& model, Section& section);

/// Gives a section whose frame does not turn another symmetry than its own, that of a more detailed
/// model: its first axis points to Theta = 0 then, and it may bend any way or not at all.
void adopt_symmetry(bool twists, bool bends, Section& section);

}  // namespace latticast
