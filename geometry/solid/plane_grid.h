// SPDX-License-Identifier: GPL-3.0-or-later
// The integer grid on which the unrolled plane is worked. The tube is a prism of flat sectors; the
// grid has the same whole number of steps in every sector, so the seam is a grid line like any
// other.
#pragma once

#include <compare>
#include <cstdint>

namespace latticast {

/// A grid point seen from one sector: 0 <= u <= sector_steps counts from the sector's left line,
/// 0 <= z <= length_steps from the segment's start. Ordered by u, then z.
struct GridPoint {
  std::int32_t u = 0;
  std::int32_t z = 0;

  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

struct PlaneGrid {
  int sectors = 0;                ///< flat sectors around the tube
  std::int32_t sector_steps = 0;  ///< steps across one sector, a power of two
  std::int32_t length_steps = 0;  ///< steps along the segment
  double u_step_mm = 0;           ///< at the radius where the plane is unrolled
  double z_step_mm = 0;

  double sector_angle_rad() const;
};

inline constexpr double finest_step_mm = 2e-5;

/// A grid of at most `step_mm`, coarser where float32 coordinates could not tell two grid points
/// apart: on long or wide tubes, and in z far along the actuator, `start_z_mm` from its beginning.
/// Precondition: sectors >= 3, sizes positive.
PlaneGrid make_plane_grid(double circumference_mm, double length_mm, int sectors,
                          double step_mm = finest_step_mm, double start_z_mm = 0);

/// A grid for a plane that stays flat: sectors only cut its outlines.
PlaneGrid make_flat_grid(double circumference_mm, double length_mm);

/// Grid steps across the thinnest strand or ring that a grid can carry.
inline constexpr double fewest_steps_across = 16;
double least_width_mm(const PlaneGrid& grid);

/// Twice the signed area of the triangle a, b, c in grid steps; exact. Positive if c lies to the
/// left of a -> b.
inline std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return std::int64_t{b.u - a.u} * (c.z - a.z) - std::int64_t{b.z - a.z} * (c.u - a.u);
}

}  // namespace latticast
