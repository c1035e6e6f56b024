// SPDX-License-Identifier: GPL-3.0-or-later
// Names of pressures and turning points as messages write them.
#pragma once

#include <string>

#include "model/equilibrium/response.h"

namespace latticast {

/// "47.3 kPa".
std::string pressure_text(double pressure_kpa);

/// What TurningPoint::name says, from its other members and the segment's length.
std::string turning_name(const TurningPoint& point, double length_mm);

}  // namespace latticast
