// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/design.h"

#include <algorithm>
#include <cmath>

namespace latticast {

double Rings::first_centre_mm() const {
  // A ring that ends on the segment's start up to rounding is on the segment.
  const double least = 0.5 * width_mm * (1 - 1e-12);
  const double centre = phase * *pitch_mm;
  return centre < least ? centre + *pitch_mm : centre;
}

// Measured from the axis: an angle and its mirror image differ in sign alone there.
StrandDirection Grid::direction() const {
  const double from_axis = radians(90 - angle_deg);
  return {std::sin(from_axis), std::cos(from_axis)};
}

bool has_curved_strands(const Lattice& lattice) {
  return std::any_of(lattice.grids.begin(), lattice.grids.end(),
                     [](const Grid& grid) { return is_curved(grid.path); });
}

}  // namespace latticast
