// SPDX-License-Identifier: GPL-3.0-or-later
// Collocation and shooting for the pulled arc (docs/horseshoe.md#equation), both followed from
// rest: methods that the model does not use, to measure it against.
#pragma once

#include <optional>

#include "model/horseshoe/arc_integrals.h"

namespace latticast {

/// beta at a strain by Chebyshev collocation of the given order >= 2: theta'' is a polynomial, the
/// boundary conditions are built into its integrals, the strain is appended, Newton's method
/// follows from rest. Empty when a step of 1/1000 of the way fails.
std::optional<double> collocated_force(const Arc& arc, double strain, int order);

/// Where shooting starts.
enum class ShootingStart {
  end,    ///< along the whole arc; unknown is the slope at the end
  middle  ///< along half of it; unknown is the logarithm of the rate of turning in the middle
};

/// beta at a strain by shooting with CVODE (Adams, dense Newton) and sensitivities, at a relative
/// tolerance; absolute ones are a hundredth of it. Newton's method follows from rest. Empty when a
/// step of 1/1000 of the way fails. Throws std::runtime_error when CVODE cannot be set up.
std::optional<double> shot_force(const Arc& arc, double strain, double tolerance,
                                 ShootingStart start);

}  // namespace latticast
