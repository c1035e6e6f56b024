// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_offsets.h"

#include <algorithm>

namespace latticast::plane_offsets {

Path box(cInt left, cInt right, cInt from, cInt to) {
  return {IntegerGrid::turned(left, from), IntegerGrid::turned(right, from),
          IntegerGrid::turned(right, to), IntegerGrid::turned(left, to)};
}

Paths part_in(const Paths& paths, const Path& window) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  clipper.AddPath(window, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctIntersection, result, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  return result;
}

Paths difference(const Paths& paths, const Paths& others) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  clipper.AddPaths(others, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return result;
}

Paths united_around_one_period(const Pattern& pattern, const IntegerGrid& grid, cInt margin) {
  ClipperLib::Clipper clipper;
  for (const Strand& strand : pattern.strands) {
    const Path path = grid.path_of(strand.outline);
    const auto [left, right] = std::minmax_element(
        path.begin(), path.end(),
        [](const auto& a, const auto& b) { return IntegerGrid::u_of(a) < IntegerGrid::u_of(b); });
    const cInt leftmost = IntegerGrid::u_of(*left);
    const cInt rightmost = IntegerGrid::u_of(*right);
    const auto first = static_cast<cInt>(std::ceil(double(-margin - rightmost) / period));
    const auto last = static_cast<cInt>(std::floor(double(period + margin - leftmost) / period));
    for (cInt copy = first; copy <= last; ++copy) {
      Path shifted = path;
      for (auto& point : shifted) point.Y -= copy * period;
      clipper.AddPath(shifted, ClipperLib::ptSubject, true);
    }
  }
  for (const cInt left : {-2 * margin, period + margin}) {
    clipper.AddPath(box(left, left + margin, 0, grid.length), ClipperLib::ptSubject, true);
  }
  clipper.AddPath(box(-2 * margin, period + 2 * margin, 0, grid.length), ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctIntersection, result, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  return result;
}

Paths offset(const Paths& paths, double distance, double flatness) {
  ClipperLib::ClipperOffset offsetter(2.0, flatness);
  offsetter.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  Paths result;
  offsetter.Execute(result, distance);
  return result;
}

}  // namespace latticast::plane_offsets
