// SPDX-License-Identifier: GPL-3.0-or-later
// Slivers: gaps between a lattice's outlines, and necks of material, that stay narrower than a
// given width for several times that width. Walls on either side of one may meet once the plane is
// wrapped and moved. Gaps are closed, necks are parted, in the plane, before anything is made of
// it.
#pragma once

#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/region.h"

namespace latticast {

struct Sliver {
  bool is_gap = true;   ///< otherwise a neck
  PlanePoint middle;    ///< of its box; 0 <= u < circumference
  double reach_mm = 0;  ///< diagonal of its box
  Strand patch;  ///< covers it; of a neck its outline runs clockwise, which takes material away
};

/// Where two outlines, or two places of one that are far from each other along it, come nearer than
/// `width_mm`, one place for all within a hundred widths or so. Linear in the edges of lattices
/// whose strands are far apart.
std::vector<PlanePoint> near_places(const Region& united, double width_mm);

/// All of the pattern's slivers: what a disc of that width closes, and what it then opens; the
/// rounding of mere corners is none. Necks are looked for where `with_necks` says so: in patterns
/// whose outlines do not overlap, as with_fillets() makes them. None where the width is less than
/// 64 steps of 2^-26 of the circumference.
std::vector<Sliver> slivers_of(const Pattern& pattern, double width_mm, bool with_necks);

/// The pattern with its slivers closed and parted, and what that adds to its error.
Pattern without_slivers(Pattern pattern, const std::vector<Sliver>& slivers, double width_mm);

}  // namespace latticast
