// SPDX-License-Identifier: GPL-3.0-or-later
// Whether strands and rings, and what lies between neighbours, are wide enough to be made.
#pragma once

#include "checks/check_finding.h"
#include "checks/lattice_use.h"
#include "design/design.h"

namespace latticast {

/// A width that is drawn square to a line at `angle_deg` from the circumference, at another radius
/// than R_c: s w / sqrt(s^2 cos^2 + sin^2), s = radius / R_c. Its extent around the tube grows with
/// the radius, its pitch along the tube stays; it is least at the inner radius.
double width_at_radius_mm(const Segment& segment, double angle_deg, double width_mm,
                          double radius_mm);

/// The same for the narrowest place of a family's strand: where it is steepest, for arcs.
double least_width_mm(const Segment& segment, const Grid& grid, double width_mm);

/// The narrowest strand or ring at its inner radius. Precondition: the segment has a lattice.
double narrowest_strand_mm(const Segment& segment);

/// strand-too-thin, ring-too-thin, layer-too-thin, gap-too-small of segment `number` (from 1): the
/// worst of every family. Neighbouring horseshoes are taken R_m/R_c closer at the inner radius than
/// at R_c, which is less than they are. Gaps that the fillet closes are none. Precondition: the
/// segment has a lattice; horseshoes can be drawn (drawing_problems.h).
CheckFindings strand_checks(const Segment& segment, int number, const LatticeUse& use);

}  // namespace latticast
