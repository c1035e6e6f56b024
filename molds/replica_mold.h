// SPDX-License-Identifier: GPL-3.0-or-later
// A flexible mold for the lattice, made around a printed pattern (the paper's way).
#pragma once

#include "molds/lattice_mold.h"

namespace latticast {

inline constexpr double replica_rubber_mm = 8;  ///< flexible rubber over the lattice

/// Pieces for two castings in one box. First the pattern stands in it, a rod with the lattice and
/// its gates on it, and mold rubber is poured around. The flexible mold is slit along one line,
/// taken off, and put back around the smooth core; the lattice's rubber goes in through the
/// channels that the gates left: the lowest one fills, the others let air out. "pattern", "core",
/// "base", "shell-1" and "shell-2" of the box, and "cap". The flexible mold is replica_rubber_mm
/// thick over the lattice and as long as a direct mold's shell. No seam meets the lattice, and no
/// strand is squeezed but by soft rubber: `pieces` and `allowed_strain` do not matter. cavity_mm3
/// is what the flexible mold takes. Throws as lattice_mold and liner_mold do.
Mold replica_mold(const LatticeMoldPlan& plan);

/// Of its box and core; the pattern is as long as the core, and narrower than the plates.
MoldExtent replica_extent(const LatticeMoldPlan& plan);

/// Plans the lattice's mold for itself.
Mold replica_mold(const Segment& segment, const LatticeMoldOptions& options);

}  // namespace latticast
