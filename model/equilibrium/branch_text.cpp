// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch_text.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "design/units.h"

namespace latticast {

std::string pressure_text(double pressure_kpa) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g kPa", pressure_kpa);
  return text;
}

std::string extremum_text(const AngleExtremum& point, double length_mm) {
  const bool bend = point.quantity == AngleKind::bend;
  const double per_mm =
      bend ? point.state.bend_magnitude_rad_per_mm() : std::abs(point.state.twist_rad_per_mm);
  const double angle = degrees(per_mm * length_mm);
  char text[160];
  std::snprintf(text, sizeof text,
                "%s angle is %s, %.4g degrees, at %s: an inverse P(%s) has two branches",
                bend ? "bending" : "twist", point.largest ? "largest" : "smallest", angle,
                pressure_text(point.pressure_kpa).c_str(), bend ? "theta" : "twist");
  return text;
}

void add_sentence(std::string& message, const std::string& sentence) {
  message += message.empty() ? sentence : "; " + sentence;
}

}  // namespace latticast
