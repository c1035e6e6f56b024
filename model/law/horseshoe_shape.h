// SPDX-License-Identifier: GPL-3.0-or-later
// Shape of a horseshoe's link: a circular arc of rectangular section. mm, MPa, rad.
#pragma once

#include "design/horseshoe.h"
#include "design/units.h"
#include "model/law/link_description.h"

namespace latticast {

struct HorseshoeShape {
  double radius_mm = 0;     ///< R_h of the centre line
  double arc_rad = 0;       ///< full angle, 2 phi0
  double width_mm = 0;      ///< w, in the plane of the arc
  double thickness_mm = 0;  ///< h, square to that plane
  double youngs_modulus_mpa = 0;

  bool operator==(const HorseshoeShape&) const = default;

  static constexpr std::string_view name = Horseshoe::key;
  LinkSizes sizes() const {
    return {{"radius_mm", radius_mm},
            {"arc_deg", degrees(arc_rad)},
            {"width_mm", width_mm},
            {"thickness_mm", thickness_mm},
            {"youngs_modulus_MPa", youngs_modulus_mpa}};
  }
};

inline HorseshoeShape shape_of(const Horseshoe& path, const Strip& strip) {
  return {.radius_mm = path.radius_mm,
          .arc_rad = radians(path.arc_deg),
          .width_mm = strip.width_mm,
          .thickness_mm = strip.thickness_mm,
          .youngs_modulus_mpa = strip.youngs_modulus_mpa};
}

}  // namespace latticast
