// SPDX-License-Identifier: GPL-3.0-or-later
// Operators on points of space, for drawing.
#pragma once

#include <cmath>

#include "geometry/mesh/point_algebra.h"

namespace latticast::vectors {

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Point operator*(double s, const Point& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

inline bool is_finite(const Point& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

}  // namespace latticast::vectors
