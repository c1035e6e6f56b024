// SPDX-License-Identifier: GPL-3.0-or-later
// Sinusoidal strands in the plane: half waves along a chord line, t = A sin(pi s/c) to the right of
// it.
#pragma once

#include <optional>
#include <string>

#include "design/strand_path.h"
#include "geometry/pattern/placed_strand.h"

namespace latticast {

/// A link is a half wave: its ends, the joints, are the zero crossings on the chord line. The first
/// half wave bulges to the right. Beyond both ends the waves go on: the segment is a level cut
/// through them.
using SinusoidStrand = Placed<Sinusoid>;

// What strand_path.h promises of any path, for sinusoids. Waves are counted on the segment, so that
// they always close.

double link_chord_mm(const SinusoidStrand& strand);
double link_length_mm(const SinusoidStrand& strand);
double largest_slope_deg(const SinusoidStrand& strand);
double reach_mm(const SinusoidStrand& strand);

/// c^2/(pi^2 A), at the crests.
double smallest_radius_mm(const SinusoidStrand& strand);

SinusoidStrand closed(SinusoidStrand strand);

/// The sinusoid of as many waves whose centre line is as long, on a chord line `stretch` times as
/// long; a fully stretched one is kept a little wavy.
Sinusoid stretched(const SinusoidStrand& strand, double stretch);

/// Inside a crest: twice the smallest radius, without the width.
double gap_within_mm(const SinusoidStrand& strand);

/// At most 1e-4 A above the true distance.
double centre_distance_mm(const SinusoidStrand& strand, double spacing_u_mm);
double centre_line_distance_mm(const SinusoidStrand& strand, double along_mm, double across_mm);

/// Always empty.
std::optional<std::string> closing_problem(const SinusoidStrand& strand);
std::optional<std::string> own_problem(const SinusoidStrand& strand);

/// Both edges are offset curves of the centre line, at half the width. They become chords within
/// `flatness_mm` that enclose, from joint to joint, exactly the area between curve and chord line;
/// neighbouring half waves share their corners bit for bit.
DrawnStrand draw_strand(const SinusoidStrand& strand, double flatness_mm);

}  // namespace latticast
