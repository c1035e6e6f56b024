// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerance budget: how a part's chord tolerance is split among the steps that make it.
#pragma once

#include "design/design.h"

namespace latticast {

/// What each step may leave the true part by, in mm. docs/geometry.md#tolerance-budget says why the
/// shares are what they are.
struct ToleranceBudget {
  double total_mm = 0;          ///< of the part
  double drawing_mm = 0;        ///< chords of curved strands, and chords of fillets, in the plane
  double facets_mm = 0;         ///< flat sectors in place of cylinders
  double walls_mm = 0;          ///< walls between two levels in place of helicoids
  double closing_mm = 0;        ///< half-width of the diamonds that close touching points
  double coarsest_step_mm = 0;  ///< of the plane's grid, where outlines graze each other
};

/// Do outlines run in every direction, as curved strands and fillets do?
bool has_curved_outlines(const Lattice& lattice);

/// Width of the thinnest strand or ring; infinite where there is none.
double thinnest_strand_mm(const Lattice& lattice);

/// Of a lattice's solid. `growth` is the largest factor by which its lines will grow later (1:
/// none). A lattice that is to be `twisted` gets walls of a quarter of their error: along a cut's
/// height they turn as much again as around a sector, and flat ones, halved by a diagonal, then
/// leave their surface by 1/4 of that in place of 1/16.
ToleranceBudget lattice_budget(const Segment& segment, double tolerance_mm, double growth,
                               bool twisted);

/// Of solids all of whose outlines are straight, but for discs (layered_solid.h).
ToleranceBudget layered_budget(double tolerance_mm);

/// Of a lattice's flat pattern, which has no facets and no walls.
ToleranceBudget flat_pattern_budget(const Lattice& lattice, double tolerance_mm);

}  // namespace latticast
