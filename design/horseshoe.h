// SPDX-License-Identifier: GPL-3.0-or-later
// Horseshoe strand: a chain of circular arcs ([Wang] Fig. 2(g)). Lengths mm, angles degrees.
#pragma once

#include <string_view>

#include "design/path_description.h"

namespace latticast {

class Field;

/// Radius of the centre line and full angle of one arc. A link is one arc.
struct Horseshoe {
  double radius_mm = 0;
  double arc_deg = 180;
  bool alternate = true;  ///< successive arcs curve to opposite sides

  static constexpr std::string_view key = "horseshoe";
  /// Of a strand that is `strand_mm` long; refuses more than limits::links arcs.
  static Horseshoe read(const Field& field, double strand_mm);
  PathDescription description() const;
  Horseshoe scaled(double factor) const { return {factor * radius_mm, arc_deg, alternate}; }

  friend bool operator==(const Horseshoe&, const Horseshoe&) = default;
};

}  // namespace latticast
