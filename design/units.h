// SPDX-License-Identifier: GPL-3.0-or-later
// Units at the interfaces. Inside, lengths are mm, stresses MPa, forces N, angles rad; designs,
// results and messages have kPa and degrees.
#pragma once

#include <numbers>

namespace latticast {

inline constexpr double pi = std::numbers::pi;

constexpr double radians(double degrees) {
  return degrees * pi / 180;
}

constexpr double degrees(double radians) {
  return radians * (180 / pi);
}

constexpr double mpa_from_kpa(double kpa) {
  return kpa / 1000;
}

constexpr double kpa_from_mpa(double mpa) {
  return mpa * 1000;
}

}  // namespace latticast
