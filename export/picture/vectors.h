// SPDX-License-Identifier: GPL-3.0-or-later
// Sums and products of points, for drawing.
#pragma once

#include <cmath>

#include "geometry/mesh/triangle_mesh.h"

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

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

inline bool is_finite(const Point& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

}  // namespace latticast::vectors
