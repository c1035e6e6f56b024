// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient of a section's energy written out a second time, straight from docs/model.md#energy
// and docs/bending.md#distributed-columns: long double, many quadrature points, derivatives by
// complex steps, horseshoe forces from solved arcs instead of interpolants. What a prediction lacks
// against it is its true error.
#pragma once

#include <array>

#include "model/section/section.h"

namespace latticast::testing {

/// dPi/dq of stored energy less P pi (a^2 lambda - R_i^2) by the wanted coordinates, 0 by the
/// others.
std::array<long double, 5> exact_gradient(const Section& section, const Deformation& at,
                                          double pressure_mpa, const std::array<bool, 5>& wanted);

}  // namespace latticast::testing
