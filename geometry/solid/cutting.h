// SPDX-License-Identifier: GPL-3.0-or-later
// How finely the solids of a segment are cut, so that they stay within their tolerance now and when
// they are deformed.
#pragma once

#include "geometry/solid/tolerance_budget.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {

/// Flat sectors around the tube.
int sectors_of(const Segment& segment, const SolidOptions& options, double facets_mm);

/// Lengths along the tube between cuts: of a mesh that is to be twisted each turns by a sector.
double bands_of(const Segment& segment, const SolidOptions& options, int sectors);

/// The largest |sin| of the angle between an outline of the lattice and the circumference, at any
/// radius of its layer (relief.h). Precondition: the segment has a lattice.
double steepest_slant(const Segment& segment);

/// Of the lattice, with what the options ask for.
struct LatticeCutting {
  ToleranceBudget budget;
  double steepness = 0;
};
LatticeCutting lattice_cutting(const Segment& segment, const SolidOptions& options);

}  // namespace latticast
