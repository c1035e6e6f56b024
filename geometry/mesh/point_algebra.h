// SPDX-License-Identifier: GPL-3.0-or-later
// Vector algebra on points of space.
#pragma once

#include <cmath>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

inline Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// from + along * direction
inline Point moved(const Point& from, const Point& direction, double along) {
  return {from[0] + along * direction[0], from[1] + along * direction[1],
          from[2] + along * direction[2]};
}

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

}  // namespace latticast
