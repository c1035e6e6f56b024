// SPDX-License-Identifier: GPL-3.0-or-later
// Force law of one half wave of a sinusoid: the planar extensible elastica with variable natural
// curvature, its ends free to turn (docs/sinusoid.md#equation).
#pragma once

#include <optional>

#include "model/law/strand_law.h"
#include "model/sinusoid/wave_equilibrium.h"

namespace latticast {

/// Strain at which the chord is as long as the centre line was.
double full_extension(const SinusoidShape& shape);

/// -0.3 to full extension + 0.5, what a law is made for.
StrainRange widest_range(const SinusoidShape& shape);

/// The half wave without units.
Wave wave_of(const SinusoidShape& shape);

/// The law over widest_range, or over a part of it. Throws LinkOutOfScope for slopes that are not
/// from 1 to 80 degrees, for w/c that is not from 1e-3 to 1, for numbers that are not positive and
/// finite; LawNotSolved where the branch from rest cannot be followed.
StrandLaw make_law(const SinusoidShape& shape);
StrandLaw make_law(const SinusoidShape& shape, const StrainRange& range);

/// Tensile strain of the most stretched fibre: the largest of delta cos(theta) + w/2 |change of
/// curvature| along the wave, at the crest when pulled. 0 at rest. Empty where no equilibrium
/// exists. Precondition: the shape is in its law's scope.
std::optional<double> largest_fibre_strain(const SinusoidShape& shape, double strain);

}  // namespace latticast
