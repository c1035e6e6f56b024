// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the molds that a design asks for can be printed, filled and opened.
#pragma once

#include "checks/check_finding.h"

namespace latticast {

struct Design;
struct LatticeMoldPlan;
class PreparedLattices;
class PreparedMolds;

inline constexpr double deepest_groove = 3;  ///< depth / width
inline constexpr int most_vents = 24;        ///< that are cut off and trimmed without a murmur

/// What a direct lattice mold takes up beside its cavity: the film of half the clearance between
/// lands and core, all along the shell, and the bores.
double beside_cavity_mm3(const LatticeMoldPlan& plan);

/// mold-impossible, mold-wall-too-thin, groove-too-deep, demolding-strain, trapped-air, many-vents,
/// pour-volume and exceeds-bed of every mold that make.lattice_mold and make.liner_mold ask for.
/// Lattice molds are planned, not made solid; replica and liner molds are made. Lattices that
/// cannot be drawn are print_checks' concern.
/// `lattices` and `molds` are those of the design, or of one with the same molds and more beside.
CheckFindings casting_checks(const Design& design, PreparedLattices& lattices,
                             PreparedMolds& molds);

}  // namespace latticast
