// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/pattern/pattern.h"

namespace latticast {

/// Rounds every inward corner of the united strands with the given radius, as a disc of that radius
/// rolled through the gaps would leave them; gaps narrower than its diameter close. Outward corners
/// stay. The result covers one period exactly; holes are outlines that run clockwise. Arcs stay
/// within `flatness_mm` of the circle. Offsetting by the Clipper library. Precondition: radius > 0,
/// smaller than half the circumference.
Pattern with_fillets(const Pattern& pattern, double radius_mm, double flatness_mm);

}  // namespace latticast
