// SPDX-License-Identifier: GPL-3.0-or-later
// The horseshoe laws of a segment's strands, and the moduli that its materials enter with.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "design/design.h"
#include "design/unsupported_design.h"
#include "model/horseshoe/horseshoe_law.h"

namespace latticast {

/// E of the lattice in MPa. Throws UnsupportedDesign when its material is not linear.
double strand_modulus_mpa(const Lattice& lattice);

/// The link of one strand; empty where strands are straight.
std::optional<HorseshoeShape> link_shape(const Segment& segment, const Grid& grid, double width_mm);

/// The distinct links of a segment's curved strands; none without a lattice.
std::vector<HorseshoeShape> link_shapes(const Segment& segment);

/// Laws, found by their shapes.
using LawsByShape =
    std::map<HorseshoeShape, std::shared_ptr<const HorseshoeLaw>, HorseshoeShapeOrder>;

/// `known` laws and those that the segment's strands need besides, built side by side. Throws
/// UnsupportedDesign for a shape outside of the law's scope.
LawsByShape build_laws(const Segment& segment, const HorseshoeLaws& known);

/// Those of `laws` that the segment can use: the laws of a long chain would be too many to hand to
/// each of its segments.
HorseshoeLaws known_laws(const LawsByShape& laws, const Segment& segment);

}  // namespace latticast
