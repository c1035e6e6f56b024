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
  for (const double centre : ring_centres_mm(*lattice.rings, pattern.length_mm)) {
    // Flush rings end exactly on the segment's ends, whatever the rounding of centre + half.
    pattern.strands.push_back(band(pattern.circumference_mm, std::max(0.0, centre - half),
                                   std::min(pattern.length_mm, centre + half)));
  }
}

HorseshoeColumn column_of(const Grid& grid, int strand, const Pattern& pattern) {
  return {*grid.horseshoe, strand * pattern.circumference_mm / grid.count(), grid.angle_deg,
          grid.widths_mm[strand], pattern.length_mm};
}

void draw_grid(const Grid& grid, double flatness, Pattern& pattern) {
  for (int i = 0; i < grid.count(); ++i) {
    if (grid.horseshoe) {
      const DrawnHorseshoe drawn = draw_horseshoe(column_of(grid, i, pattern), flatness);
      pattern.strands.insert(pattern.strands.end(), drawn.arcs.begin(), drawn.arcs.end());
      pattern.error += drawn.error;
    } else {
      const double start = i * pattern.circumference_mm / grid.count();
      pattern.strands.push_back(
          straight_strip(start, grid.angle_deg, grid.widths_mm[i], pattern.length_mm));
    }
  }
}

}  // namespace

DrawingError& DrawingError::operator+=(const DrawingError& other) {
  distance_mm = std::max(distance_mm, other.distance_mm);
  area_mm2 += other.area_mm2;
  return *this;
}

Pattern draw_lattice(const Segment& segment, double flatness_mm) {
  const double circumference = segment.lattice_circumference_mm();
  Pattern pattern{circumference, segment.length_mm, {}};
  std::string problems;
  for (const std::string& problem : drawing_problems(segment)) problems += "\n  " + problem;
  if (!problems.empty()) throw CannotDraw("the lattice cannot be drawn:" + problems);
  draw_rings(*segment.lattice, pattern);
  for (const Grid& grid : segment.lattice->grids) draw_grid(grid, flatness_mm, pattern);
  return pattern;
}

Pattern draw_sleeve(double radius_mm, double length_mm) {
  const double circumference = 2 * std::numbers::pi * radius_mm;
  return {circumference, length_mm, {band(circumference, 0, length_mm)}};
}

}  // namespace latticast
