// SPDX-License-Identifier: GPL-3.0-or-later
// Response to pressure of a section with effective rods.
#pragma once

#include <span>

#include "model/effective_rods/rods.h"
#include "model/equilibrium/response.h"

namespace latticast {

/// Fills in states, status, turning points and message. A pressure at which a horseshoe would
/// leave its law's range has no state. Turning points of the bending angle are looked for between
/// rest and the outermost pressures, on a grid of 64 steps, and located by a bracketed root search.
void predict_rods(const Rods& rods, double length_mm, std::span<const double> pressures_kpa,
                  Held held, Response& response);

}  // namespace latticast
