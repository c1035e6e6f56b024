// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/fillet.h"

#include <algorithm>
#include <cmath>

#include <polyclipping/clipper.hpp>

namespace latticast {
namespace {

using ClipperLib::cInt;
using ClipperLib::Path;
using ClipperLib::Paths;

// Offsetting works on integers. The period is a whole number of them, so that what is drawn on
// either side of the seam is the same; 2^24 of them are finer than float32.
constexpr cInt period = cInt{1} << 24;

struct IntegerGrid {
  double step_mm;
  Path path_of(const std::vector<PlanePoint>& outline, cInt shift) const {
    Path path;
    for (const PlanePoint& p : outline) {
      path.emplace_back(std::llround(p.u / step_mm) + shift, std::llround(p.z / step_mm));
    }
    return path;
  }
};

// The strands' copies that reach into [-margin, period + margin].
Paths copies_around_one_period(const Pattern& pattern, const IntegerGrid& grid, cInt margin) {
  Paths copies;
  for (const Strand& strand : pattern.strands) {
    const Path path = grid.path_of(strand.outline, 0);
    const auto [left, right] = std::minmax_element(
        path.begin(), path.end(), [](const auto& a, const auto& b) { return a.X < b.X; });
    const auto first = static_cast<cInt>(std::ceil(double(-margin - right->X) / period));
    const auto last = static_cast<cInt>(std::floor(double(period + margin - left->X) / period));
    for (cInt copy = first; copy <= last; ++copy) {
      copies.push_back(grid.path_of(strand.outline, copy * period));
    }
  }
  return copies;
}

Paths united(const Paths& paths) {
  Paths result;
  ClipperLib::SimplifyPolygons(paths, result, ClipperLib::pftNonZero);
  return result;
}

Paths offset(const Paths& paths, double distance, double flatness) {
  ClipperLib::ClipperOffset offsetter(2.0, flatness);
  offsetter.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  Paths result;
  offsetter.Execute(result, distance);
  return result;
}

Paths clipped(const Paths& paths, cInt length) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  clipper.AddPath({{0, 0}, {period, 0}, {period, length}, {0, length}}, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctIntersection, result, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  return result;
}

}  // namespace

Pattern with_fillets(const Pattern& pattern, double radius_mm, double flatness_mm) {
  const IntegerGrid grid{pattern.circumference_mm / static_cast<double>(period)};
  const double radius = radius_mm / grid.step_mm;
  const double flatness = flatness_mm / grid.step_mm;
  const auto margin = static_cast<cInt>(4 * radius);
  const Paths drawn = united(copies_around_one_period(pattern, grid, margin));
  const Paths closed = offset(offset(drawn, radius, flatness), -radius, flatness);
  Pattern result{pattern.circumference_mm, pattern.length_mm, {}};
  for (const Path& path : clipped(closed, std::llround(pattern.length_mm / grid.step_mm))) {
    Strand strand;
    for (const auto& point : path) {
      strand.outline.push_back({static_cast<double>(point.X) * grid.step_mm,
                                static_cast<double>(point.Y) * grid.step_mm});
    }
    result.strands.push_back(std::move(strand));
  }
  return result;
}

}  // namespace latticast
