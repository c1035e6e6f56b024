// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/pattern.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/pattern/cannot_draw.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/pattern/rings.h"
#include "geometry/pattern/straight_path.h"
#include "geometry/pattern/strand_path.h"

namespace latticast {
namespace {

std::array<PlanePoint, 4> band(double circumference, double z_from, double z_to) {
  return {{{0, z_from}, {circumference, z_from}, {circumference, z_to}, {0, z_to}}};
}

void draw_rings(const Lattice& lattice, Pattern& pattern) {
  if (!lattice.rings) return;
  const double half = 0.5 * lattice.rings->width_mm;
  int number = 0;
  for (const double centre : ring_centres_mm(*lattice.rings, pattern.length_mm)) {
    // Flush rings end exactly on the segment's ends, whatever the rounding of centre + half.
    pattern.strands.push_back(
        traced_strip(band(pattern.circumference_mm, std::max(0.0, centre - half),
                          std::min(pattern.length_mm, centre + half)),
                     0, {.shape = {}, .part = CurvePart::ring, .strand = number++}));
  }
}

void draw_family(const Segment& segment, int family, double flatness, Pattern& pattern) {
  const Grid& grid = segment.lattice->grids[family];
  for (int i = 0; i < grid.count(); ++i) {
    DrawnStrand drawn = draw_strand(placed_strand(segment, grid, i), flatness);
    for (Strand& link : drawn.links) {
      for (DrawnCurve& curve : link.curves) {
        curve.family = family;
        curve.strand = i;
      }
      pattern.strands.push_back(std::move(link));
    }
    pattern.error += drawn.error;
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
  for (const std::string& problem : drawing_problems(segment)) {
    problems += "\n  " + problem;
  }
  if (!problems.empty()) throw CannotDraw("the lattice cannot be drawn:" + problems);
  draw_rings(*segment.lattice, pattern);
  const auto families = static_cast<int>(segment.lattice->grids.size());
  for (int i = 0; i < families; ++i) draw_family(segment, i, flatness_mm, pattern);
  return pattern;
}

Pattern draw_sleeve(double radius_mm, double length_mm) {
  const double circumference = 2 * std::numbers::pi * radius_mm;
  const std::array<PlanePoint, 4> corners = band(circumference, 0, length_mm);
  return {circumference, length_mm, {{.outline = {corners.begin(), corners.end()}}}};
}

}  // namespace latticast
