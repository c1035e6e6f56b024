// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/tube_solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/region.h"
#include "geometry/solid/relief.h"

namespace latticast {
namespace {

// How finely a solid must be cut so that it stays within the tolerance, now and when it is deformed.
struct Cutting {
  int columns = 0;
  std::vector<std::int32_t> heights;
};

// An edge of a twisted mesh turns by its own angle around the tube plus the twist over its height, and
// no longer has corners pushed outwards: half of the permitted angle (sagitta r D^2/8) goes to each.
int columns_of(const Segment& segment, const SolidOptions& options) {
  const double radius = segment.outer_radius_mm();
  int columns = columns_for(radius, options.tolerance_mm);
  if (options.twist_rad_per_mm != 0 || options.stretch_radius != 1) {
    const double grown = radius * std::max(1.0, options.stretch_radius);
    const double share = options.twist_rad_per_mm != 0 ? 0.5 : 1.0;
    const double angle = share * std::sqrt(8 * options.tolerance_mm / grown);
    columns = std::max(columns, static_cast<int>(std::ceil(2 * std::numbers::pi / angle)));
  }
  return columns;
}

Cutting cutting(const Segment& segment, const SolidOptions& options, const PlaneGrid& grid) {
  Cutting cut{grid.columns, {}};
  const double turn = std::abs(options.twist_rad_per_mm) * segment.length_mm;
  const double bands = std::ceil(turn / grid.column_angle_rad());
  if (bands > grid.length_steps / 16.0) {
    throw GeometryError("the preview twists so far that it would need " + std::to_string(bands) +
                        " cuts along the tube; use a coarser tolerance");
  }
  for (int i = 1; i < bands; ++i) {
    cut.heights.push_back(static_cast<std::int32_t>(std::lround(i * (grid.length_steps / bands))));
  }
  return cut;
}

// The largest |sin| of the angle between a slanted outline and the circumference.
double steepest_slant(const Segment& segment) {
  double steepest = 0;
  if (!segment.lattice) return steepest;
  for (const Grid& grid : segment.lattice->grids) {
    if (grid.angle_deg == 90) continue;
    steepest = std::max(steepest, std::sin(grid.angle_deg * std::numbers::pi / 180));
  }
  return steepest;
}

Solid wrap_pattern(const Segment& segment, const SolidOptions& options, Pattern pattern,
                   double floor_mm, double ceiling_mm) {
  const double mid_radius = pattern.circumference_mm / (2 * std::numbers::pi);
  const PlaneGrid grid =
      make_plane_grid(pattern.circumference_mm, segment.length_mm, columns_of(segment, options));
  const Cutting cut = cutting(segment, options, grid);
  const Region region = unite(std::move(pattern), grid, cut.heights, options.tolerance_mm);
  const Relief relief{triangulate(region),
                      wall_radii(floor_mm, ceiling_mm, grid.column_angle_rad(),
                                 steepest_slant(segment), options.tolerance_mm),
                      options.start_z_mm};
  Solid solid;
  solid.mesh = wrap(relief);
  const double layer = (ceiling_mm * ceiling_mm - floor_mm * floor_mm) / (2 * mid_radius);
  const double area = area_mm2(region);
  solid.volume_mm3 = area * layer;
  // Floor and ceiling lie within the tolerance of their cylinders.
  solid.volume_bound_mm3 = area / mid_radius * (ceiling_mm + floor_mm) * options.tolerance_mm;
  solid.pieces = pieces(relief.plane);
  solid.genus = outline_loops(region) - solid.pieces;
  return solid;
}

}  // namespace

Solid lattice_solid(const Segment& segment, const SolidOptions& options) {
  return wrap_pattern(segment, options, draw_lattice(segment), segment.liner_outer_radius_mm(),
                      segment.outer_radius_mm());
}

Solid liner_solid(const Segment& segment, const SolidOptions& options) {
  const double inner = segment.inner_radius_mm();
  const double outer = segment.liner_outer_radius_mm();
  return wrap_pattern(segment, options, draw_sleeve(0.5 * (inner + outer), segment.length_mm), inner,
                      outer);
}

}  // namespace latticast
