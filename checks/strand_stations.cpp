// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/strand_stations.h"

#include <algorithm>
#include <cmath>

#include "design/units.h"
#include "model/shape/inflated_wall.h"

namespace latticast {
namespace {

bool winds_with_bending(const Segment& segment, const Grid& grid, const State& state) {
  const double angle = grid.angle_rad();
  const double turn = grid.angle_deg == 90
                          ? 0
                          : std::cos(angle) / std::sin(angle) / segment.lattice_mid_radius_mm();
  const double scale = std::abs(turn) + std::abs(state.frame_turn_rad_per_mm);
  return std::abs(turn - state.frame_turn_rad_per_mm) <= 1e-9 * scale;
}

}  // namespace

std::vector<StrandStation> strand_stations(const Segment& segment, const Grid& grid,
                                           const State& state) {
  std::vector<StrandStation> stations;
  const double longer = lengthened_side_rad(state);
  const bool straight = state.bend_magnitude_rad_per_mm() == 0;
  const bool placed = !straight && winds_with_bending(segment, grid, state);
  std::vector<double> seen;
  for (int j = 0; j < grid.count(); ++j) {
    const double width = grid.widths_mm[j];
    if (placed) {
      stations.push_back({j, 2 * pi * j / grid.count(), width});
      continue;
    }
    if (std::find(seen.begin(), seen.end(), width) != seen.end()) continue;
    seen.push_back(width);
    stations.push_back({j, longer, width});
    if (!straight) stations.push_back({j, longer + pi, width});
  }
  return stations;
}

}  // namespace latticast
