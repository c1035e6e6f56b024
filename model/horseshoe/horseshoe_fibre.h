// SPDX-License-Identifier: GPL-3.0-or-later
// The most strained fibre of a horseshoe arc, where it would tear.
#pragma once

#include <optional>

#include "model/horseshoe/horseshoe_law.h"

namespace latticast {

/// Tensile strain of the most stretched fibre when the arc's chord is strained by `strain`. It lies
/// in mid-arc, where both the pull and its moment are largest:
///     delta + w/(2 R_h) |1 - theta'(0)|,   theta'(0)^2 = 1 + 2 beta (cos theta_e - 1)
///                                                          + beta delta (cos^2 theta_e - 1)
/// from the invariant of MODEL.md section 4, theta_e the slope at the end. 0 at rest. Empty where
/// no arc exists. Precondition: the shape is in its law's scope.
std::optional<double> largest_fibre_strain(const HorseshoeShape& shape, double strain);

}  // namespace latticast
