// SPDX-License-Identifier: GPL-3.0-or-later
// Straight strands in the plane: strips of constant width along the chord line.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "design/strand_path.h"
#include "geometry/pattern/placed_strand.h"

namespace latticast {

/// The whole strand is one link.
using StraightStrand = Placed<StraightPath>;

// What strand_path.h promises of any path, for straight strands.

double link_chord_mm(const StraightStrand& strand);
double link_length_mm(const StraightStrand& strand);
double largest_slope_deg(const StraightStrand& strand);
double reach_mm(const StraightStrand& strand);
double smallest_radius_mm(const StraightStrand& strand);
StraightStrand closed(StraightStrand strand);
StraightPath stretched(const StraightStrand& strand, double stretch);
double gap_within_mm(const StraightStrand& strand);
double centre_distance_mm(const StraightStrand& strand, double spacing_u_mm);
double centre_line_distance_mm(const StraightStrand& strand, double along_mm, double across_mm);
std::optional<std::string> closing_problem(const StraightStrand& strand);
std::optional<std::string> own_problem(const StraightStrand& strand);

/// A strip with four corners, two sides of which are the strand's or ring's: from corner `right`
/// and from `right` + 2 to the next, the right one first, in turn along it and against it.
Strand traced_strip(const std::array<PlanePoint, 4>& corners, std::size_t right, DrawnCurve owner);

/// A parallelogram, without any error.
DrawnStrand draw_strand(const StraightStrand& strand, double flatness_mm);

}  // namespace latticast
