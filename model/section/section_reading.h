// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-section of a segment of the design: strands and rings counted as they are drawn.
#pragma once

#include "design/design.h"
#include "design/unsupported_design.h"
#include "model/law/strand_law.h"
#include "model/section/section.h"

namespace latticast {

/// Reads a segment into a section.
///   layered:  rubber over R_i..R_m, lattice over R_m..R_o, fractions counted from widths and pitch
///             (docs/model.md#energy); strands with a law of their own at R_c
///   mixture:  c1 rubber + c2 lattice over R_i..R_o, c1 = 0.91, c2 = 0.09, no strip fractions
///             ([Wang] (1), (5)); without a lattice there is nothing to mix and c1 = 1
/// Rings that do not exist (none given, or none fits on the segment) leave k_t = 0, whatever the
/// joint. `known` laws are reused where they fit; missing ones are built, side by side.
/// Families that are uneven around the tube (unequal strands, or a single one) fix the section's
/// frame. Throws UnsupportedDesign for two of them that wind at different rates (no frame in which
/// the section stays the same), for curved strands or uneven families in a mixture wall (which
/// counts no strips), for a link outside of its law's scope, for a linear liner, for a lattice
/// material that is not linear, for straight strands of one family that overlap at mid radius, and
/// for a clear-span joint between rings that touch. Precondition: the segment is valid in the
/// sense of design/read_design.h.
Section prepare_section(const Segment& segment, const ModelChoice& model,
                        const StrandLaws& known = {});

/// The laws that a section uses.
StrandLaws laws_of(const Section& section);

}  // namespace latticast
