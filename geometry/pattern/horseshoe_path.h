// SPDX-License-Identifier: GPL-3.0-or-later
// Horseshoe strands in the plane: a chain of circular arcs along a chord line ([Wang] Fig. 2(g)).
#pragma once

#include <optional>
#include <string>

#include "design/strand_path.h"
#include "geometry/pattern/placed_strand.h"

namespace latticast {

/// Joints between arcs lie on the chord line; the first arc bulges to the right of it, the next one
/// to the left when `alternate`, otherwise all to the right. Beyond both ends the chain goes on:
/// the segment is a level cut through it.
using HorseshoeColumn = Placed<Horseshoe>;

/// Distance between the ends of one arc, 2 R sin(arc/2).
double chord_mm(const Horseshoe& shape);

/// Arcs on a segment, as a real number: L / (chord sin angle).
double arcs_on_segment(const HorseshoeColumn& column);

/// The radius nearest to the column's at which a whole number of arcs (at least one) fills the
/// segment.
double closing_radius_mm(const HorseshoeColumn& column);

// What strand_path.h promises of any path, for horseshoes.

double link_chord_mm(const HorseshoeColumn& column);
double link_length_mm(const HorseshoeColumn& column);
double largest_slope_deg(const HorseshoeColumn& column);
double reach_mm(const HorseshoeColumn& column);
double smallest_radius_mm(const HorseshoeColumn& column);

/// With the closing radius.
HorseshoeColumn closed(HorseshoeColumn column);

/// The circular arc of the same length whose chord is `stretch` times as long; a fully stretched
/// arc is kept a little round.
Horseshoe stretched(const HorseshoeColumn& column, double stretch);

/// Inside an arc, and between arcs of more than a half circle that bulge to the same side: the next
/// but one (alternate), or the next.
double gap_within_mm(const HorseshoeColumn& column);

/// At most 1e-4 R above the true distance.
double centre_distance_mm(const HorseshoeColumn& column, double spacing_u_mm);
double centre_line_distance_mm(const HorseshoeColumn& column, double along_mm, double across_mm);

std::optional<std::string> closing_problem(const HorseshoeColumn& column);
std::optional<std::string> own_problem(const HorseshoeColumn& column);

/// Drawn with the closing radius. Arcs become chords that stay within `flatness_mm` of the circle
/// and enclose exactly its area; neighbouring arcs share their corners bit for bit. The corner
/// between arcs on one side is rounded by a disc of the strand's width.
DrawnStrand draw_strand(const HorseshoeColumn& column, double flatness_mm);

}  // namespace latticast
