// SPDX-License-Identifier: GPL-3.0-or-later
// Where a segment's rings sit along the tube.
#pragma once

#include <vector>

#include "design/design.h"

namespace latticast {

/// Centre-to-centre distance of the rings in mm: (L - w)/(n - 1) for rings
/// given by count, the stated pitch otherwise.
double ring_pitch_mm(const Rings& rings, double segment_length_mm);

/// Ring centres in ascending z, mm from the segment's start. Rings given by count are flush with
/// both ends; rings given by pitch have centres at (phase + i) p, and only rings that lie wholly on
/// the segment exist (none, when the segment is shorter than the first one's far edge).
std::vector<double> ring_centres_mm(const Rings& rings, double segment_length_mm);

}  // namespace latticast
