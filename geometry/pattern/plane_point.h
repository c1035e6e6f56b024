// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the unrolled plane, and vector algebra on them.
#pragma once

#include <cmath>

namespace latticast {

/// In mm: u around the tube, z along it.
struct PlanePoint {
  double u = 0;
  double z = 0;
};

inline PlanePoint middle(PlanePoint a, PlanePoint b) {
  return {0.5 * (a.u + b.u), 0.5 * (a.z + b.z)};
}

inline double distance(PlanePoint a, PlanePoint b) {
  return std::hypot(b.u - a.u, b.z - a.z);
}

/// Twice the signed area of the triangle a, b, c; positive if c lies to the left of a -> b.
inline double cross(PlanePoint a, PlanePoint b, PlanePoint c) {
  return (b.u - a.u) * (c.z - a.z) - (b.z - a.z) * (c.u - a.u);
}

}  // namespace latticast
