// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets of a pattern's strands (Clipper): one period of the plane on integers.
#pragma once

#include <cmath>
#include <vector>

#include <polyclipping/clipper.hpp>

#include "geometry/pattern/pattern.h"

namespace latticast::plane_offsets {

using ClipperLib::cInt;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Offsetting works on integers. The period is a whole number of them, so that what is drawn on
/// either side of the seam is the same; 2^26 of them are finer than float32.
inline constexpr cInt period = cInt{1} << 26;

struct IntegerGrid {
  double u_step_mm;
  double z_step_mm;  // the length need not be a whole number of u's steps
  cInt length;

  explicit IntegerGrid(const Pattern& pattern)
      : u_step_mm(pattern.circumference_mm / static_cast<double>(period)),
        z_step_mm(u_step_mm),
        length(std::llround(pattern.length_mm / u_step_mm)) {
    if (length > 0) z_step_mm = pattern.length_mm / static_cast<double>(length);
  }

  Path path_of(const std::vector<PlanePoint>& outline) const {
    Path path;
    for (const PlanePoint& p : outline) {
      path.push_back(turned(std::llround(p.u / u_step_mm), std::llround(p.z / u_step_mm)));
    }
    return path;
  }

  std::vector<PlanePoint> outline_of(const Path& path) const {
    std::vector<PlanePoint> outline;
    for (const auto& point : path) {
      outline.push_back({static_cast<double>(u_of(point)) * u_step_mm,
                         static_cast<double>(z_of(point)) * z_step_mm});
    }
    return outline;
  }

  // Clipper sweeps along Y, and where many arcs end at one Y its time grows with the square of
  // their points. Strands end at common heights, seldom at a common u.
  static ClipperLib::IntPoint turned(cInt u, cInt z) { return {z, -u}; }
  static cInt u_of(const ClipperLib::IntPoint& point) { return -point.Y; }
  static cInt z_of(const ClipperLib::IntPoint& point) { return point.X; }
};

Path box(cInt left, cInt right, cInt from, cInt to);

Paths part_in(const Paths& paths, const Path& window);

/// What `paths` cover and `others` do not.
Paths difference(const Paths& paths, const Paths& others);

/// The union of the strands' copies that reach into [-margin, period + margin], with a bar on
/// either side in place of their cut ends: rounding each of those would take longer than all that
/// is kept.
Paths united_around_one_period(const Pattern& pattern, const IntegerGrid& grid, cInt margin);

/// All outlines moved outwards by `distance`, or inwards where it is negative; round corners keep
/// within `flatness` of their arcs.
Paths offset(const Paths& paths, double distance, double flatness);

}  // namespace latticast::plane_offsets
