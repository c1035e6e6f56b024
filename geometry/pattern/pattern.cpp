// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "design/units.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/pattern/horseshoe_path.h"
#include "geometry/pattern/rings.h"

namespace latticast {
namespace {

Strand band(double circumference, double z_from, double z_to) {
  return {{{0, z_from}, {circumference, z_from}, {circumference, z_to}, {0, z_to}}};
}

// Two of a quadrangle's sides are the strand's: they run from corners `right` and `right` + 2, the
// right one first, in turn along the strand and against it.
void trace_sides(Strand& strip, std::size_t right, DrawnCurve owner) {
  strip.traces.assign(4, {own_line, 0, 1});
  for (const std::size_t corner : {right, (right + 2) % 4}) {
    owner.side = corner == right ? 1 : -1;
    owner.shape = StraightLine{strip.outline[corner], strip.outline[(corner + 1) % 4]};
    strip.traces[corner].curve = static_cast<std::uint32_t>(strip.curves.size());
    strip.curves.push_back(owner);
  }
}

Strand straight_strip(double start_u, double angle_deg, double width, double length) {
  const double angle = radians(angle_deg);
  const double half = 0.5 * width / std::sin(angle);
  // The cotangent of 90 degrees is exactly 0, so that axial columns are drawn axial.
  const double drift = angle_deg == 90 ? 0.0 : length * std::cos(angle) / std::sin(angle);
  return {{{start_u - half, 0},
           {start_u + half, 0},
           {start_u + drift + half, length},
           {start_u + drift - half, length}}};
}

void draw_rings(const Lattice& lattice, Pattern& pattern) {
  if (!lattice.rings) return;
  const double half = 0.5 * lattice.rings->width_mm;
  int number = 0;
  for (const double centre : ring_centres_mm(*lattice.rings, pattern.length_mm)) {
    // Flush rings end exactly on the segment's ends, whatever the rounding of centre + half.
    Strand ring = band(pattern.circumference_mm, std::max(0.0, centre - half),
                       std::min(pattern.length_mm, centre + half));
    trace_sides(ring, 0, {.shape = {}, .part = CurvePart::ring, .strand = number++});
    pattern.strands.push_back(std::move(ring));
  }
}

HorseshoeColumn column_of(const Grid& grid, int strand, const Pattern& pattern) {
  return {*grid.horseshoe, strand * pattern.circumference_mm / grid.count(), grid.angle_deg,
          grid.widths_mm[strand], pattern.length_mm};
}

void draw_family(const Grid& grid, int family, double flatness, Pattern& pattern) {
  for (int i = 0; i < grid.count(); ++i) {
    if (grid.horseshoe) {
      DrawnHorseshoe drawn = draw_horseshoe(column_of(grid, i, pattern), flatness);
      for (Strand& arc : drawn.arcs) {
        for (DrawnCurve& curve : arc.curves) {
          curve.family = family;
          curve.strand = i;
        }
        pattern.strands.push_back(std::move(arc));
      }
      pattern.error += drawn.error;
    } else {
      const double start = i * pattern.circumference_mm / grid.count();
      Strand strip = straight_strip(start, grid.angle_deg, grid.widths_mm[i], pattern.length_mm);
      trace_sides(
          strip, 1,
          {.shape = {}, .part = CurvePart::strand, .family = family, .strand = i, .link = 0});
      pattern.strands.push_back(std::move(strip));
    }
  }
}

}  // namespace

DrawingError& DrawingError::operator+=(const DrawingError& other) {
  distance_mm = std::max(distance_mm, other.distance_mm);
  area_mm2 += other.area_mm2;
  return *this;
}

Strand moved(Strand strand, PlanePoint by) {
  for (PlanePoint& p : strand.outline) p = {p.u + by.u, p.z + by.z};
  for (DrawnCurve& curve : strand.curves) curve.shape = moved(curve.shape, by);
  return strand;
}

Pattern draw_lattice(const Segment& segment, double flatness_mm) {
  const double circumference = segment.lattice_circumference_mm();
  Pattern pattern{circumference, segment.length_mm, {}};
  std::string problems;
  for (const std::string& problem : drawing_problems(segment)) problems += "\n  " + problem;
  if (!problems.empty()) throw CannotDraw("the lattice cannot be drawn:" + problems);
  draw_rings(*segment.lattice, pattern);
  int family = 0;
  for (const Grid& grid : segment.lattice->grids) {
    draw_family(grid, family++, flatness_mm, pattern);
  }
  return pattern;
}

Pattern draw_sleeve(double radius_mm, double length_mm) {
  const double circumference = 2 * std::numbers::pi * radius_mm;
  return {circumference, length_mm, {band(circumference, 0, length_mm)}};
}

}  // namespace latticast
