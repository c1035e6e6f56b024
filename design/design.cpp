// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/design.h"

#include <cmath>

namespace latticast {

// Measured from the axis: an angle and its mirror image differ in sign alone there.
StrandDirection Grid::direction() const {
  const double from_axis = radians(90 - angle_deg);
  return {std::sin(from_axis), std::cos(from_axis)};
}

}  // namespace latticast
