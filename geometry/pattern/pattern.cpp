// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/pattern.h"

#include <cmath>
#include <numbers>
#include <string>

#include "geometry/pattern/rings.h"
#include "spec/unsupported_design.h"

namespace latticast {
namespace {

Strand band(double circumference, double z_from, double z_to) {
  return {{{0, z_from}, {circumference, z_from}, {circumference, z_to}, {0, z_to}}};
}

Strand straight_strip(double start_u, double angle_deg, double width, double length) {
  const double angle = angle_deg * std::numbers::pi / 180;
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

void draw_grid(const Grid& grid, Pattern& pattern) {
  if (grid.horseshoe) {
    throw UnsupportedDesign(
        "horseshoe strands cannot be drawn yet: leave 'horseshoe' out of the grid at " +
        std::to_string(grid.angle_deg) + " degrees to draw it straight");
  }
  const double spacing = pattern.circumference_mm / grid.count();
  for (int i = 0; i < grid.count(); ++i) {
    pattern.strands.push_back(
        straight_strip(i * spacing, grid.angle_deg, grid.widths_mm[i], pattern.length_mm));
  }
}

}  // namespace

Pattern draw_lattice(const Segment& segment) {
  const double circumference = 2 * std::numbers::pi * segment.lattice_mid_radius_mm();
  Pattern pattern{circumference, segment.length_mm, {}};
  draw_rings(*segment.lattice, pattern);
  for (const Grid& grid : segment.lattice->grids) draw_grid(grid, pattern);
  return pattern;
}

Pattern draw_sleeve(double radius_mm, double length_mm) {
  const double circumference = 2 * std::numbers::pi * radius_mm;
  return {circumference, length_mm, {band(circumference, 0, length_mm)}};
}

}  // namespace latticast
