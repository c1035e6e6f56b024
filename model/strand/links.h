// SPDX-License-Identifier: GPL-3.0-or-later
// Links of a segment's strands and their force laws, shared by shape. Which path a strand follows
// is asked here and nowhere else in the model.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "design/design.h"
#include "design/unsupported_design.h"
#include "model/law/strand_law.h"

namespace latticast {

/// E of the lattice in MPa. Throws UnsupportedDesign when its material is not linear.
double strand_modulus_mpa(const Lattice& lattice);

/// The link of one strand; empty where strands are straight.
std::optional<LinkShape> link_shape(const Segment& segment, const Grid& grid, double width_mm);

/// The distinct links of a segment's curved strands; none without a lattice.
std::vector<LinkShape> link_shapes(const Segment& segment);

/// Strain at which the chord is as long as the link's centre line was.
double full_extension(const LinkShape& shape);

/// Tensile strain of the most stretched fibre when the link's chord is strained by `strain`; 0 at
/// rest. Empty where no equilibrium exists. Precondition: the shape is in its law's scope.
std::optional<double> largest_fibre_strain(const LinkShape& shape, double strain);

/// The law over the widest range that it is made for. Throws LinkOutOfScope; LawNotSolved.
StrandLaw make_law(const LinkShape& shape);

/// The laws of `shapes`, in that order. Each distinct shape is solved once and its law shared,
/// found in n log n; distinct ones are solved side by side on up to `threads` threads (0: as many
/// as the machine has). Throws as make_law does, after all threads have come back.
StrandLaws make_laws(std::span<const LinkShape> shapes, int threads = 0);

/// Laws, found by their shapes.
using LawsByShape = std::map<LinkShape, std::shared_ptr<const StrandLaw>, LinkShapeOrder>;

/// `known` laws and those that the segment's strands need besides, built side by side. Throws
/// UnsupportedDesign for a shape outside of its law's scope.
LawsByShape build_laws(const Segment& segment, const StrandLaws& known);

/// Those of `laws` that the segment can use: the laws of a long chain would be too many to hand to
/// each of its segments.
StrandLaws known_laws(const LawsByShape& laws, const Segment& segment);

}  // namespace latticast
