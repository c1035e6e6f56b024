// SPDX-License-Identifier: GPL-3.0-or-later
// Shape of a sinusoid's link: a half wave A sin(pi s/c) of rectangular section. mm, MPa.
#pragma once

#include "design/sinusoid.h"
#include "model/law/link_description.h"

namespace latticast {

struct SinusoidShape {
  double amplitude_mm = 0;  ///< A of the centre line
  double chord_mm = 0;      ///< c, half a wave length
  double width_mm = 0;      ///< w, in the plane of the wave
  double thickness_mm = 0;  ///< h, square to that plane
  double youngs_modulus_mpa = 0;

  bool operator==(const SinusoidShape&) const = default;

  static constexpr std::string_view name = Sinusoid::key;
  LinkSizes sizes() const {
    return {{"amplitude_mm", amplitude_mm},
            {"chord_mm", chord_mm},
            {"width_mm", width_mm},
            {"thickness_mm", thickness_mm},
            {"youngs_modulus_MPa", youngs_modulus_mpa}};
  }
};

inline SinusoidShape shape_of(const Sinusoid& path, const Strip& strip) {
  return {.amplitude_mm = path.amplitude_mm,
          .chord_mm = strip.chord_mm,
          .width_mm = strip.width_mm,
          .thickness_mm = strip.thickness_mm,
          .youngs_modulus_mpa = strip.youngs_modulus_mpa};
}

}  // namespace latticast
