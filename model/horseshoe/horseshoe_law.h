// SPDX-License-Identifier: GPL-3.0-or-later
// Force law of one horseshoe arc: the extensible elastica of a circular arc with pinned ends
// ([Wang] Appendix C; docs/horseshoe.md#method).
#pragma once

#include <optional>

#include "model/horseshoe/arc_integrals.h"
#include "model/law/strand_law.h"

namespace latticast {

/// Distance of the ends at rest, 2 R_h sin(phi0).
double rest_chord_mm(const HorseshoeShape& shape);

/// Strain at which the chord is as long as the arc was: phi0/sin(phi0) - 1.
double full_extension(const HorseshoeShape& shape);

/// -0.3 to full extension + 0.5, what a law is made for.
StrainRange widest_range(const HorseshoeShape& shape);

/// The arc's table in units of E I/R_h^2. Precondition: 0 < half angle < pi, compliance > 0, the
/// range holds 0 and is finite. Throws LawNotSolved.
ForceTable arc_table(const Arc& arc, const StrainRange& range);

/// The law over widest_range, or over a part of it. Throws LinkOutOfScope for arcs that are not
/// from 20 to 300 degrees, for w/R_h that is not from 1e-3 to 100, for numbers that are not
/// positive and finite; LawNotSolved, which has not been seen within the scope.
StrandLaw make_law(const HorseshoeShape& shape);
StrandLaw make_law(const HorseshoeShape& shape, const StrainRange& range);

/// Tensile strain of the most stretched fibre when the arc's chord is strained by `strain`. It lies
/// in mid-arc, where both the pull and its moment are largest:
///     delta + w/(2 R_h) |1 - theta'(0)|,   theta'(0)^2 = 1 + 2 beta (cos theta_e - 1)
///                                                          + beta delta (cos^2 theta_e - 1)
/// from the invariant of docs/horseshoe.md#equation, theta_e the slope at the end. 0 at rest. Empty
/// where no arc exists. Precondition: the shape is in its law's scope.
std::optional<double> largest_fibre_strain(const HorseshoeShape& shape, double strain);

}  // namespace latticast
