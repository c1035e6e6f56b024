// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/layered_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/solid/relief.h"

namespace latticast {
namespace {

constexpr double on_radius = 0.005;  // of the radius: corners and chords lie this near to it
constexpr double on_height_mm = 1e-6;

PlaneGrid grid_of(const LayeredTube& tube, double tolerance_mm) {
  const double circumference = 2 * std::numbers::pi * tube.drawn_radius_mm;
  const double outer = tube.layers.back().ceiling_mm;
  return make_plane_grid(circumference, tube.length_mm, sectors_for(outer, tolerance_mm),
                         finest_step_mm, tube.start_z_mm);
}

}  // namespace

Solid layered_solid(const LayeredTube& tube, double tolerance_mm) {
  const PlaneGrid grid = grid_of(tube, tolerance_mm);
  std::vector<Pattern> sheets = tube.sheets;
  if (!tube.sheet_0_is_closed) {
    sheets[0] = closed_pattern(std::move(sheets[0]), grid, tolerance_mm);
  }
  std::vector<std::int32_t> cuts;
  for (const double z : tube.cuts_mm) {
    cuts.push_back(static_cast<std::int32_t>(std::lround(z / grid.z_step_mm)));
  }
  const Region region = layered_region(sheets, grid, cuts, tube.filling);
  Relief relief{triangulate(region), {}, tube.start_z_mm};
  Solid solid;
  std::vector<double> steepness;
  for (std::size_t i = 0; i < tube.layers.size(); ++i) {
    const RadialLayer& layer = tube.layers[i];
    relief.radii_mm.push_back(
        wall_radii(layer.floor_mm, layer.ceiling_mm, grid.sector_angle_rad(),
                   steepness.emplace_back(layer.steepness.value_or(tube.steepness)), tolerance_mm));
    const double per_radius = area_mm2(region, static_cast<int>(i)) / tube.drawn_radius_mm;
    const double both = layer.ceiling_mm + layer.floor_mm;
    solid.volume_mm3 += 0.5 * per_radius * both * (layer.ceiling_mm - layer.floor_mm);
    solid.volume_bound_mm3 += per_radius * both * tolerance_mm;
  }
  solid.mesh = wrap(relief);
  solid.error = solid_error(region, relief.radii_mm, tube.drawn_radius_mm, steepness);
  const ReliefTopology counted = topology(relief);
  solid.pieces = counted.pieces;
  solid.genus = counted.genus;
  return solid;
}

Pattern closed_sheet_0(const LayeredTube& tube, double tolerance_mm) {
  return closed_pattern(tube.sheets[0], grid_of(tube, tolerance_mm), tolerance_mm);
}

Strand drawn_band(double drawn_radius_mm, double z_from_mm, double z_to_mm) {
  return drawn_window(drawn_radius_mm, 0, 2 * std::numbers::pi, z_from_mm, z_to_mm);
}

Strand drawn_window(double drawn_radius_mm, double from_rad, double to_rad, double z_from_mm,
                    double z_to_mm) {
  const double left = drawn_radius_mm * from_rad;
  const double right = drawn_radius_mm * to_rad;
  return {{{left, z_from_mm}, {right, z_from_mm}, {right, z_to_mm}, {left, z_to_mm}}};
}

Strand drawn_disc(double drawn_radius_mm, double at_rad, double z_mm, double radius_mm,
                  double flatness_mm) {
  const double step = std::min(0.5, std::sqrt(12 * flatness_mm / radius_mm));
  const int steps = std::max(12, static_cast<int>(std::ceil(2 * std::numbers::pi / step)));
  const double angle = 2 * std::numbers::pi / steps;
  const double corner = radius_mm * std::sqrt(angle / std::sin(angle));
  const PlanePoint centre{drawn_radius_mm * at_rad, z_mm};
  Strand strand;
  strand.curves = {{.shape = CircularArc{.centre = centre,
                                         .radius_mm = radius_mm,
                                         .from_rad = 0,
                                         .to_rad = 2 * std::numbers::pi}}};
  for (int i = 0; i < steps; ++i) {
    strand.outline.push_back(
        {centre.u + corner * std::cos(i * angle), centre.z + corner * std::sin(i * angle)});
    strand.traces.push_back({0, double(i) / steps, double(i + 1) / steps});
  }
  return strand;
}

DrawingError disc_error(double radius_mm, double flatness_mm) {
  return {flatness_mm, flatness_mm * std::sqrt(12 * flatness_mm * radius_mm)};
}

double chamfer_tolerance_mm(double tolerance_mm, double radius_mm) {
  return std::min(tolerance_mm, 0.8 * on_radius * radius_mm);
}

void chamfer(Solid& solid, double z_mm, double radius_mm, double depth_mm) {
  const double small_mm = radius_mm - depth_mm;
  const double factor = small_mm / radius_mm;
  for (Point& p : solid.mesh.vertices) {
    if (std::abs(p[2] - z_mm) > on_height_mm) continue;
    if (std::abs(std::hypot(p[0], p[1]) / radius_mm - 1) > on_radius) continue;
    p[0] *= factor;
    p[1] *= factor;
  }
  // What is left there is a truncated cone.
  const double square = radius_mm * radius_mm;
  const double cone = (square + radius_mm * small_mm + small_mm * small_mm) / 3;
  solid.volume_mm3 -= std::numbers::pi * depth_mm * (square - cone);
}

}  // namespace latticast
