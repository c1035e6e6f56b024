// SPDX-License-Identifier: GPL-3.0-or-later
// Tube with one even family of straight strips and evenly pitched rings, or why a segment is none.
// mm, rad, MPa.
#pragma once

#include <optional>
#include <string>

#include "design/design.h"

namespace latticast {

/// A tube with `strips` equal helical strips and rings, all of one layer.
struct StripTube {
  double inner_radius_mm = 0;
  double liner_outer_radius_mm = 0;
  double outer_radius_mm = 0;
  double angle_rad = 0;  ///< of the strips, from the circumference, at the layer's mid radius
  int strips = 0;
  double strip_width_mm = 0;
  double pitch_mm = 0;       ///< of the rings
  double ring_width_mm = 0;  ///< 0: no rings, and any pitch
  Law liner;
  Linear lattice;
};

/// A segment's tube of strips, or why it is none.
struct FoundStrips {
  std::optional<StripTube> tube;
  std::string reason;  ///< "knows straight strands, these are curved"
};

/// Strips and rings must leave gaps; a segment without rings is one ring pitch of any length.
FoundStrips find_strips(const Segment& segment);

}  // namespace latticast
