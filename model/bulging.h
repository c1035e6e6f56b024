// SPDX-License-Identifier: GPL-3.0-or-later
// Bulging of the liner through the free gaps of its lattice, and where it balloons there.
// Derivation, assumptions and comparison with finite elements: docs/bulging.md.
#pragma once

#include <string>
#include <vector>

#include "design/design.h"
#include "model/equilibrium/state.h"
#include "model/prepared_segment.h"

namespace latticast {

/// A long strip of wall between two members that hold its edges, as it is now: stretched already.
struct WallPatch {
  Law law;                       ///< of the liner; a linear one counts as neo-Hookean, mu = E/3
  double span_mm = 0;            ///< b > 0, clear distance of the members
  double thickness_mm = 0;       ///< t > 0
  double stretch_squared = 1;    ///< n . F F^T n, n pointing across the gap
  double across_wall = 1;        ///< stretch through the thickness
  double invariant_minus_3 = 0;  ///< I1 - 3
  double tension_n_per_mm = 0;   ///< of the whole wall across the gap, strands included, >= 0
};

/// Pressure in MPa that a patch takes to come out by `height_mm` (>= 0) in mid gap, as a circular
/// cap; without what a tube's roundness adds. For small heights
///     height (8 tension/b^2 + 1/(b^2/(8 S) + b^4/(384 D))),
/// S the shear and D the bending stiffness of the strip at its present stretch. Infinite where a
/// Gent rubber is at its limit.
double cap_pressure_mpa(const WallPatch& patch, double height_mm);

/// The bulge of one kind of gap.
struct Bulge {
  std::string members;   ///< "rings", or "grid 1": what holds the wall on both sides of the gap
  double gap_mm = 0;     ///< clear distance now, the widest of them; 0: closed
  double load_mpa = 0;   ///< contact pressure that the members take off the wall, on average; the
                         ///< wall in the gap lacks it
  double height_mm = 0;  ///< beyond the members, mid gap; HUGE_VAL when it balloons
  double largest_load_mpa = 0;  ///< load beyond which there is no equilibrium in the gap: the wall
                                ///< balloons there; looked for up to a height of twice the gap
                                ///< or four radii

  bool balloons() const { return load_mpa > largest_load_mpa; }
};

/// One bulge for the gaps between rings and one for every grid, on the side that bending lengthens.
/// In mid cell those of rings and grids add up. Empty without a lattice; members that do not press
/// on the wall (under suction, or axial strands) leave a height of 0. A grid's strands are counted
/// with the widest of their gaps. Precondition: `prepared` is `segment` prepared, `state` its own.
std::vector<Bulge> liner_bulges(const Segment& segment, const PreparedSegment& prepared,
                                const State& state);

}  // namespace latticast
