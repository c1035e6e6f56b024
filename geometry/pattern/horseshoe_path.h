// SPDX-License-Identifier: GPL-3.0-or-later
// Horseshoe columns, drawn flat: a chain of circular arcs along a straight chord line (paper Fig.
// 2(g)).
#pragma once

#include <string>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "spec/design.h"

namespace latticast {

/// One column. Its chord line starts at (start_u, 0) and runs at `angle_deg` from the circumference
/// to z = length. Joints between arcs lie on the chord line; the first arc bulges to the right of
/// it, the next one to the left when `alternate`, otherwise all to the right.
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

/// What keeps the column from being drawn, each with the nearest value that works; empty if nothing
/// does. A column whose radius is within 0.2 % of the closing radius closes: it is drawn with that.
std::vector<std::string> drawing_problems(const HorseshoeColumn& column);

/// Smallest clear distance between two neighbouring columns of equal shape, `spacing_u_mm` apart
/// along u, with the widths given; negative when they overlap. Sampled at 1/200 of an arc.
double clearance_mm(const HorseshoeColumn& column, double spacing_u_mm, double neighbour_width_mm);

/// The most columns around the tube that leave a gap between neighbours of these widths; at
/// least 1.
int most_columns(const HorseshoeColumn& column, double circumference_mm, double neighbour_width_mm);

/// Outlines, one polygon an arc, cut level at both ends. Arcs become chords that stay within
/// `flatness_mm` of the circle and enclose exactly its area. Precondition: no drawing problems.
std::vector<Strand> draw_horseshoe(const HorseshoeColumn& column, double flatness_mm);

}  // namespace latticast
