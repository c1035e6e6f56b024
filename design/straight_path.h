// SPDX-License-Identifier: GPL-3.0-or-later
// Straight strand: its chord line itself, a helix on the tube.
#pragma once

#include "design/path_description.h"

namespace latticast {

struct StraightPath {
  PathDescription description() const {
    return {.name = "straight",
            .noun = "a straight strip",
            .text = {},
            .more = "strands nearer to the circumference",
            .narrower = {},
            .parameters = {}};
  }
  StraightPath scaled(double /*factor*/) const { return *this; }

  friend bool operator==(const StraightPath&, const StraightPath&) = default;
};

}  // namespace latticast
