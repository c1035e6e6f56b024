// SPDX-License-Identifier: GPL-3.0-or-later
// Why horseshoe columns cannot be drawn as asked, and what could be instead.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "design/design.h"
#include "geometry/pattern/pattern.h"

namespace latticast {

/// What keeps a segment's horseshoe columns from being drawn, one line each: the key of the family,
/// the strand and its place around the tube where not all are concerned, and the nearest value that
/// works. Empty if nothing does. A family may fail to
/// - close: no whole number of arcs fills the segment, by more than 0.2 % of the radius (within
///   that, it is drawn with the closing radius);
/// - stay apart: an arc folds over itself (w >= 2 R), runs into the next arc but one (alternate) or
///   into the next (one-sided, above 180 degrees);
/// - hold together: bulge past an end of the segment so far that the level cut parts a strand.
/// Strands of equal widths are named once. Precondition: a validated segment.
std::vector<std::string> drawing_problems(const Segment& segment);

/// Where columns of a family overlap, in the same words: what is drawn is one net, which stretches
/// and bends as no separate columns do.
std::vector<std::string> overlapping_neighbours(const Segment& segment);

/// Throws CannotDraw with the problems of all segments, if there are any.
void require_drawable(std::span<const Segment> segments);

}  // namespace latticast
