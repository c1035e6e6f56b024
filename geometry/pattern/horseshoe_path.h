// SPDX-License-Identifier: GPL-3.0-or-later
// Horseshoe columns, drawn flat: a chain of circular arcs along a straight chord line (paper Fig.
// 2(g)).
#pragma once

#include <vector>

#include "design/design.h"
#include "geometry/pattern/pattern.h"

namespace latticast {

/// One column. Its chord line starts at (start_u, 0) and runs at `angle_deg` from the circumference
/// to z = length. Joints between arcs lie on the chord line; the first arc bulges to the right of
/// it, the next one to the left when `alternate`, otherwise all to the right. Beyond both ends the
/// chain goes on: the segment is a level cut through it.
struct HorseshoeColumn {
  Horseshoe shape;
  double start_u_mm = 0;
  double angle_deg = 90;
  double width_mm = 0;
  double length_mm = 0;  ///< of the segment, along z
};

/// Distance between the ends of one arc, 2 R sin(arc/2).
double chord_mm(const Horseshoe& shape);

/// Arcs on a segment, as a real number: L / (chord sin angle).
double arcs_on_segment(const HorseshoeColumn& column);

/// The radius nearest to the column's at which a whole number of arcs (at least one) fills the
/// segment.
double closing_radius_mm(const HorseshoeColumn& column);

/// Smallest distance between the centre lines of two columns of equal shape, `spacing_u_mm` apart
/// along u; at most 1e-4 R above the true one. It is the same all along the tube.
double centre_distance_mm(const HorseshoeColumn& column, double spacing_u_mm);

/// Distance of a place from an endless column's centre line: `along_mm` is measured along the chord
/// line from one of its joints, after which an arc bulges to the right, `across_mm` to the right of
/// it.
double centre_line_distance_mm(const Horseshoe& shape, double along_mm, double across_mm);

/// Outlines, one polygon an arc, drawn with the closing radius and cut level at both ends; what the
/// cut leaves loose beyond the strand's first way out of the segment is left out. Arcs become
/// chords that stay within `flatness_mm` of the circle and enclose exactly its area; neighbouring
/// arcs share their corners bit for bit. The corner between arcs on one side is rounded by a disc
/// of the strand's width. Precondition: 0 < width < 2 R, flatness > 0.
struct DrawnHorseshoe {
  std::vector<Strand> arcs;
  DrawingError error;        ///< of the chords that were made
  bool in_one_piece = true;  ///< false: an arc bulges past an end so far that it parts the strand
};
DrawnHorseshoe draw_horseshoe(const HorseshoeColumn& column, double flatness_mm);

}  // namespace latticast
