// SPDX-License-Identifier: GPL-3.0-or-later
// Fillets of a drawn lattice: morphological closing of its outline with a disc, by offsets of
// polygons (Clipper).
#pragma once

#include "geometry/pattern/pattern.h"

namespace latticast {

/// Rounds every inward corner of the united strands with the given radius, as a disc of that radius
/// leaves them when it rolls along the outline, also in front of the segment's ends; gaps narrower
/// than its diameter close. Outward corners stay, to 1/20 of `flatness_mm`; fillets are chords
/// within `flatness_mm` of the circle, which the result's error tells with that of the pattern. The
/// result covers one period exactly; holes are outlines that run clockwise; edges keep the curve
/// that they follow, fillets an arc of the radius (rounded_outline.h). A radius below 2^-24 of
/// the circumference changes nothing. Offsetting by the Clipper library. Precondition: 0 < radius <
/// circumference / (2 pi).
Pattern with_fillets(const Pattern& pattern, double radius_mm, double flatness_mm);

}  // namespace latticast
