// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of links: the smallest repeated piece of a curved strand, as cut, with its modulus. Two
// links of equal shape have one force law. mm, MPa, rad.
#pragma once

#include <cmath>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace latticast {

/// A circular arc of rectangular section.
struct HorseshoeShape {
  double radius_mm = 0;     ///< R_h of the centre line
  double arc_rad = 0;       ///< full angle, 2 phi0
  double width_mm = 0;      ///< w, in the plane of the arc
  double thickness_mm = 0;  ///< h, square to that plane
  double youngs_modulus_mpa = 0;

  bool operator==(const HorseshoeShape&) const = default;
};

/// A half wave A sin(pi s/c) of rectangular section.
struct SinusoidShape {
  double amplitude_mm = 0;  ///< A of the centre line
  double chord_mm = 0;      ///< c, half a wave length
  double width_mm = 0;      ///< w, in the plane of the wave
  double thickness_mm = 0;  ///< h, square to that plane
  double youngs_modulus_mpa = 0;

  bool operator==(const SinusoidShape&) const = default;
};

/// Whether a number can be a size or a modulus: positive and finite.
inline bool is_size(double x) {
  return x > 0 && std::isfinite(x);
}

using LinkShape = std::variant<HorseshoeShape, SinusoidShape>;

/// A total order of shapes to look them up by, NaN included: std::strong_order of their numbers.
struct LinkShapeOrder {
  bool operator()(const LinkShape& a, const LinkShape& b) const;
};

/// A shape as files and messages write it.
struct LinkDescription {
  std::string_view name;                                   ///< of its path: "horseshoe"
  std::vector<std::pair<std::string_view, double>> sizes;  ///< name with unit, value
};
LinkDescription describe(const LinkShape& shape);

/// The description's name alone.
std::string_view path_name(const LinkShape& shape);

}  // namespace latticast
