// SPDX-License-Identifier: GPL-3.0-or-later
// Area of a strand's outline, and whether a point of the plane lies in it, for tests of drawn
// paths.
#pragma once

#include <cstddef>

#include "geometry/pattern/pattern.h"

namespace latticast {

/// Shoelace formula, mm^2; positive for a counter-clockwise outline.
inline double area(const Strand& strand) {
  double twice = 0;
  for (std::size_t i = 0; i < strand.outline.size(); ++i) {
    const PlanePoint& a = strand.outline[i];
    const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
    twice += a.u * b.z - b.u * a.z;
  }
  return 0.5 * twice;
}

/// Even-odd rule; either answer on the outline itself.
inline bool holds(const Strand& strand, PlanePoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < strand.outline.size(); ++i) {
    const PlanePoint& a = strand.outline[i];
    const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
    if ((a.z > p.z) == (b.z > p.z)) continue;
    if (p.u < a.u + (p.z - a.z) / (b.z - a.z) * (b.u - a.u)) inside = !inside;
  }
  return inside;
}

}  // namespace latticast
