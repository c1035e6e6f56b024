// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of pressures and angle extrema as messages write them.
#pragma once

#include <string>

#include "model/equilibrium/response.h"

namespace latticast {

/// "47.3 kPa".
std::string pressure_text(double pressure_kpa);

/// What AngleExtremum::name says, from its other members and the segment's length.
std::string extremum_text(const AngleExtremum& point, double length_mm);

/// Adds to a message of sentences that semicolons part.
void add_sentence(std::string& message, const std::string& sentence);

}  // namespace latticast
