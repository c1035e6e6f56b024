// SPDX-License-Identifier: GPL-3.0-or-later
// What a design asks of its molds, as the molds take it.
#pragma once

namespace latticast {

struct Design;
struct LatticeMoldOptions;
struct LinerMoldOptions;
struct Material;
struct Segment;

/// The strain that a cast strand is given on demolding: a quarter of the material's elongation at
/// break, because a rubber that is peeled out of a groove again and again is stretched far below
/// it; 0.5 where the material states none.
double demolding_strain(const Material& cast);

/// Precondition: the design asks for a lattice mold, and the segment has a lattice.
LatticeMoldOptions lattice_mold_options(const Design& design, const Segment& segment);

/// Precondition: the design asks for a liner mold.
LinerMoldOptions liner_mold_options(const Design& design, const Segment& segment);

}  // namespace latticast
