// SPDX-License-Identifier: GPL-3.0-or-later
// Whether rings and strands fit on their segment. Each rule stays silent where a number that it
// needs is NaN because it has been refused already.
#pragma once

#include "design/design.h"
#include "design/table_reader.h"

namespace latticast {

/// Rings leave gaps and at least one lies on the segment. `field` is the count or pitch to blame.
void check_rings(const Rings& rings, double segment_length_mm, const Field& field);

/// Strands of one family do not touch: with the share 2 pi R_c sin(alpha)/n of each of n strands,
/// the widths add up to less than n shares, and neighbours have (w_j + w_{j+1})/2 below one share.
void check_strand_gaps(const Grid& grid, const Segment& segment, const Field& width);

/// One strand does not wind around the tube more often than limits::strand_turns.
void check_strand_turns(const Grid& grid, const Segment& segment, const Field& angle);

/// A fillet is smaller than the mid radius of the layer that it is in.
void check_fillet(const Segment& segment, const Field& fillet);

/// Strands and rings do not cross more often than limits::crossings, so that the lattice can be
/// built.
void check_crossings(const Segment& segment, const Field& lattice);

}  // namespace latticast
