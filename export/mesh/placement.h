// SPDX-License-Identifier: GPL-3.0-or-later
// Affine map of space: where a file puts a mesh.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The images of x, y and z, then of the origin: p becomes p[0]*column[0] + p[1]*column[1] +
/// p[2]*column[2] + column[3].
using Placement = std::array<Point, 4>;

constexpr Placement in_place{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

/// First `inner`, then `outer`.
inline Placement placed(const Placement& outer, const Placement& inner) {
  Placement result{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      result[column][row] = outer[0][row] * inner[column][0] + outer[1][row] * inner[column][1] +
                            outer[2][row] * inner[column][2] + (column == 3 ? outer[3][row] : 0);
    }
  }
  return result;
}

/// Rounded to float32 once; exactly `point` for in_place, whose products would lose the sign of
/// zero.
inline Point placed(const Placement& placement, const Point& point) {
  if (placement == in_place) {
    return point;
  }
  Point result;
  for (std::size_t row = 0; row < 3; ++row) {
    result[row] = static_cast<float>(placement[0][row] * point[0] + placement[1][row] * point[1] +
                                     placement[2][row] * point[2] + placement[3][row]);
  }
  return result;
}

/// Whether the map turns surfaces inside out.
inline bool mirrors(const Placement& p) {
  return p[0][0] * (p[1][1] * p[2][2] - p[2][1] * p[1][2]) -
             p[1][0] * (p[0][1] * p[2][2] - p[2][1] * p[0][2]) +
             p[2][0] * (p[0][1] * p[1][2] - p[1][1] * p[0][2]) <
         0;
}

}  // namespace latticast
