// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/fillet.h"

#include <algorithm>
#include <cmath>

#include "geometry/solid/plane_offsets.h"
#include "geometry/solid/rounded_outline.h"

namespace latticast {
namespace {

using namespace plane_offsets;

constexpr double finest_radius = 4;          // in those steps
constexpr double first_offset_share = 0.05;  // of the flatness: it blunts outward corners
constexpr double nearest_points = 2;         // in steps: closer ones are what rounding leaves
constexpr double finest_arc_share = 0.25;    // of the radius: Clipper draws no arc coarser
// Clipper rounds an arc's number of chords, so that one may turn by 1.5 times what is asked for;
// its sagitta grows with the square.
constexpr double worst_sagitta = 2.25;
constexpr double fillet_fineness = 1 / worst_sagitta;

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
  Pattern result{pattern.circumference_mm, pattern.length_mm, {}};
  const double off = std::min(flatness_mm, finest_arc_share * radius_mm);
  const double rounding = (nearest_points + 1) * grid.u_step_mm;
  const RoundedOutlineTracer tracer(pattern,
                                    {.radius_mm = radius_mm,
                                     .rounding_mm = 2 * (first_offset_share * off + rounding),
                                     .flatness_mm = off + pattern.error.distance_mm});
  for (const Path& path : closed) {
    Strand strand;
    strand.outline = grid.outline_of(path);
    tracer.trace(strand);
    result.strands.push_back(std::move(strand));
  }
  result.error = pattern.error;
  result.error.distance_mm += (1 + worst_sagitta * first_offset_share) * off + rounding;
  result.error.area_mm2 += area_beside_chords(result, radius_mm, off);
  return result;
}

}  // namespace latticast
