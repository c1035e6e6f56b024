// SPDX-License-Identifier: GPL-3.0-or-later
// How a part looks, in mesh formats that keep colours or numbers.
#pragma once

#include <span>

#include "export/colour.h"

namespace latticast {

/// It refers to lists that live as long as it does.
struct MeshLook {
  Colour colour = usual_colour;                   ///< of the whole part
  std::span<const Colour> vertex_colours = {};    ///< one for each vertex, or none
  std::span<const double> vertex_qualities = {};  ///< a number for each vertex, or none
};

}  // namespace latticast
