// SPDX-License-Identifier: GPL-3.0-or-later
// Wedge mesh of a whole tube of strips, or of one of its helical sectors, for finite-element
// programs: rings where they are drawn, ends included (docs/decks.md).
#pragma once

#include <vector>

#include "geometry/mesh/wedge_mesh.h"
#include "model/cell/strip_cell.h"

namespace latticast {

/// A strip and the gap beside it from end to end: the tube is `tube.strips` of them. `ring_centres`
/// ascending, rings within the length; `whole` merges all sectors.
WedgeMesh strip_wedges(const StripTube& tube, double length_mm,
                       const std::vector<double>& ring_centres_mm, const StripDivision& division,
                       bool whole);

}  // namespace latticast
