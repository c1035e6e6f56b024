// SPDX-License-Identifier: GPL-3.0-or-later
// Strand paths in the plane: outline, sizes and neighbours of a strand, whatever line it follows.
// Each path has a home of its own (straight_path.h, horseshoe_path.h,
// sinusoid_path.h); nobody else asks which one a
// strand has. Method of each: docs/geometry.md.
#pragma once

#include <optional>
#include <string>

#include "design/design.h"
#include "geometry/pattern/placed_strand.h"

namespace latticast {

/// Strand number `number` of a grid, with the path as designed. Precondition: it exists, the
/// segment has a lattice.
PlacedStrand placed_strand(const Segment& segment, const Grid& grid, int number = 0);

/// Distance between the ends of a link, along the chord line.
double link_chord_mm(const PlacedStrand& strand);

/// Of a link's centre line.
double link_length_mm(const PlacedStrand& strand);

/// Largest angle between centre line and chord line.
double largest_slope_deg(const PlacedStrand& strand);

/// How far the centre line leaves the chord line.
double reach_mm(const PlacedStrand& strand);

/// Smallest radius of curvature of the centre line; HUGE_VAL for a straight one.
double smallest_radius_mm(const PlacedStrand& strand);

/// The strand with the path as it is drawn: a whole number of links fills the segment.
PlacedStrand closed(const PlacedStrand& strand);

/// The path of the same length whose chord line is `stretch` times as long.
StrandPath stretched(const PlacedStrand& strand, double stretch);

/// Smallest gap between the strand and itself; HUGE_VAL for a straight one.
double gap_within_mm(const PlacedStrand& strand);

/// Smallest distance between the centre lines of two endless strands of equal shape, `spacing_u_mm`
/// apart along u. It is the same all along the tube.
double centre_distance_mm(const PlacedStrand& strand, double spacing_u_mm);

/// Distance of a place from an endless strand's centre line: `along_mm` is measured along the chord
/// line from its start, `across_mm` to the right of it. Exact for places nearer than the path's own
/// width of curve, not below the true distance elsewhere.
double centre_line_distance_mm(const PlacedStrand& strand, double along_mm, double across_mm);

/// Why no whole number of links fills the segment, and what does; empty when one does closely
/// enough to be drawn without a word.
std::optional<std::string> closing_problem(const PlacedStrand& strand);

/// Why a strand of this width cannot be drawn by itself, and the nearest value that works.
std::optional<std::string> own_problem(const PlacedStrand& strand);

/// Outlines with the closed path. Curves become chords within `flatness_mm`, and each link keeps
/// its area. Precondition: no own_problem, flatness > 0.
DrawnStrand draw_strand(const PlacedStrand& strand, double flatness_mm);

}  // namespace latticast
