// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/plane_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace latticast {
namespace {

// Float32 keeps 24 bits: steps of 2^-22 of the largest coordinate stay at least two of its units
// apart.
constexpr double float_resolution = 0x1p-22;

}  // namespace

double PlaneGrid::sector_angle_rad() const {
  return 2 * std::numbers::pi / sectors;
}

PlaneGrid make_plane_grid(double circumference_mm, double length_mm, int sectors, double step_mm,
                          double start_z_mm) {
  const double u_step = std::max(step_mm, circumference_mm * float_resolution);
  const double farthest_z = std::max(std::abs(start_z_mm), std::abs(start_z_mm + length_mm));
  const double z_step = std::max(step_mm, farthest_z * float_resolution);
  const double sector_width = circumference_mm / sectors;
  const auto steps = std::max<std::uint64_t>(4, std::llround(sector_width / u_step));
  PlaneGrid grid;
  grid.sectors = sectors;
  grid.sector_steps = static_cast<std::int32_t>(std::bit_ceil(steps));
  grid.length_steps = static_cast<std::int32_t>(std::max(4.0, std::round(length_mm / z_step)));
  grid.u_step_mm = sector_width / grid.sector_steps;
  grid.z_step_mm = length_mm / grid.length_steps;
  return grid;
}

PlaneGrid make_flat_grid(double circumference_mm, double length_mm) {
  constexpr int few_sectors = 16;  // narrow ones have few edges to look at
  return make_plane_grid(circumference_mm, length_mm, few_sectors);
}

double least_width_mm(const PlaneGrid& grid) {
  return fewest_steps_across * std::max(grid.u_step_mm, grid.z_step_mm);
}

}  // namespace latticast
