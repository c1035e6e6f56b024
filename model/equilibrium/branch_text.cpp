// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch_text.h"

#include <cmath>
#include <numbers>

#include "design/text/written_number.h"
#include "design/units.h"

namespace latticast {

std::string pressure_text(double pressure_kpa) {
  return written(pressure_kpa, 4) + " kPa";
}

std::string extremum_text(const AngleExtremum& point, double length_mm) {
  const bool bend = point.quantity == AngleKind::bend;
  const double per_mm =
      bend ? point.state.bend_magnitude_rad_per_mm() : std::abs(point.state.twist_rad_per_mm);
  const double angle = degrees(per_mm * length_mm);
  return std::string(bend ? "bending" : "twist") + " angle is " +
         (point.largest ? "largest, " : "smallest, ") + written(angle, 4) + " degrees, at " +
         pressure_text(point.pressure_kpa) + ": an inverse P(" + (bend ? "theta" : "twist") +
         ") has two branches";
}

void add_sentence(std::string& message, const std::string& sentence) {
  message += message.empty() ? sentence : "; " + sentence;
}

}  // namespace latticast
