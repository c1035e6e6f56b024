// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/fillet.h"

#include <algorithm>
#include <cmath>

#include <polyclipping/clipper.hpp>

#include "geometry/solid/rounded_outline.h"

namespace latticast {
namespace {

using ClipperLib::cInt;
using ClipperLib::Path;
using ClipperLib::Paths;

// Offsetting works on integers. The period is a whole number of them, so that what is drawn on
// either side of the seam is the same; 2^26 of them are finer than float32.
constexpr cInt period = cInt{1} << 26;
constexpr double finest_radius = 4;          // in those steps
constexpr double first_offset_share = 0.05;  // of the flatness: it blunts outward corners
constexpr double nearest_points = 2;         // in steps: closer ones are what rounding leaves
constexpr double finest_arc_share = 0.25;    // of the radius: Clipper draws no arc coarser
// Clipper rounds an arc's number of chords, so that one may turn by 1.5 times what is asked for;
// its sagitta grows with the square.
constexpr double worst_sagitta = 2.25;
constexpr double fillet_fineness = 1 / worst_sagitta;

struct IntegerGrid {
  double u_step_mm;
  cInt length;

  explicit IntegerGrid(const Pattern& pattern)
      : u_step_mm(pattern.circumference_mm / static_cast<double>(period)),
        length(std::llround(pattern.length_mm / u_step_mm)) {}

  Path path_of(const std::vector<PlanePoint>& outline) const {
    Path path;
    for (const PlanePoint& p : outline) {
      path.push_back(turned(std::llround(p.u / u_step_mm), std::llround(p.z / u_step_mm)));
    }
    return path;
  }

  // Clipper sweeps along Y, and where many arcs end at one Y its time grows with the square of
  // their points. Strands end at common heights, seldom at a common u.
  static ClipperLib::IntPoint turned(cInt u, cInt z) { return {z, -u}; }
  static cInt u_of(const ClipperLib::IntPoint& point) { return -point.Y; }
  static cInt z_of(const ClipperLib::IntPoint& point) { return point.X; }
};

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

// The union of the strands' copies that reach into [-margin, period + margin], with a bar on either
// side in place of their cut ends: rounding each of those would take longer than all that is kept.
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

// Grown by the radius, and shrunk again. In between, the bars lose their rounded corners: all of an
// arc's points shrink towards one, which Clipper meets with time that grows with their square.
Paths closed_by_disc(const Paths& drawn, const IntegerGrid& grid, double radius, double flatness,
                     cInt margin) {
  const Paths grown = offset(drawn, radius, first_offset_share * flatness);
  const cInt half = margin / 2;
  const Path window = box(-margin - half, period + margin + half, -margin, grid.length + margin);
  Paths closed = offset(part_in(grown, window), -radius, fillet_fineness * flatness);
  ClipperLib::CleanPolygons(closed, nearest_points);
  return part_in(closed, box(0, period, 0, grid.length));
}

// What lies between a fillet and its chord is c^3 / (12 r). Edges as short as a chord are taken for
// one: arcs of strands among them, for which that is too much.
double area_beside_chords(const Pattern& pattern, double radius_mm, double flatness_mm) {
  const double longest = 2.02 * std::sqrt(2 * radius_mm * flatness_mm);
  double cubes = 0;
  for (const Strand& strand : pattern.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& a = strand.outline[i];
      const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
      const double chord = std::hypot(b.u - a.u, b.z - a.z);
      if (chord <= longest) cubes += chord * chord * chord;
    }
  }
  return cubes / (12 * radius_mm);
}

}  // namespace

Pattern with_fillets(const Pattern& pattern, double radius_mm, double flatness_mm) {
  const IntegerGrid grid(pattern);
  const double radius = radius_mm / grid.u_step_mm;
  if (radius < finest_radius || grid.length < 1) return pattern;
  const double flatness = flatness_mm / grid.u_step_mm;
  const auto margin = static_cast<cInt>(4 * radius);
  const Paths drawn = united_around_one_period(pattern, grid, margin);
  const Paths closed = closed_by_disc(drawn, grid, radius, flatness, margin);
  // The length need not be a whole number of steps.
  const double z_step_mm = pattern.length_mm / static_cast<double>(grid.length);
  Pattern result{pattern.circumference_mm, pattern.length_mm, {}};
  const double off = std::min(flatness_mm, finest_arc_share * radius_mm);
  const double rounding = (nearest_points + 1) * grid.u_step_mm;
  const RoundedOutlineTracer tracer(pattern,
                                    {.radius_mm = radius_mm,
                                     .rounding_mm = 2 * (first_offset_share * off + rounding),
                                     .flatness_mm = off + pattern.error.distance_mm});
  for (const Path& path : closed) {
    Strand strand;
    for (const auto& point : path) {
      strand.outline.push_back({static_cast<double>(IntegerGrid::u_of(point)) * grid.u_step_mm,
                                static_cast<double>(IntegerGrid::z_of(point)) * z_step_mm});
    }
    tracer.trace(strand);
    result.strands.push_back(std::move(strand));
  }
  result.error = pattern.error;
  result.error.distance_mm += (1 + worst_sagitta * first_offset_share) * off + rounding;
  result.error.area_mm2 += area_beside_chords(result, radius_mm, off);
  return result;
}

}  // namespace latticast
