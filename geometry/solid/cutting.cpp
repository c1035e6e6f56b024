// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/cutting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/solid/relief.h"

namespace latticast {

// The chord around a sector of a twisted mesh has an angle around the tube of its own and one from
// the twist over a cut's height, and its ends are not pushed outwards: either angle may be half of
// the one whose sagitta, r D^2/8, is the tolerance.
int sectors_of(const Segment& segment, const SolidOptions& options, double facets_mm) {
  const double radius = segment.outer_radius_mm();
  int sectors = sectors_for(radius, facets_mm);
  if (options.twist_rad_per_mm != 0 || options.stretch_radius != 1) {
    const double grown = radius * std::max(1.0, options.stretch_radius);
    const double share = options.twist_rad_per_mm != 0 ? 0.5 : 1.0;
    const double angle = share * std::sqrt(8 * options.tolerance_mm / grown);
    sectors = std::max(sectors, static_cast<int>(std::ceil(2 * std::numbers::pi / angle)));
  }
  return sectors << options.refinement;
}

double bands_of(const Segment& segment, const SolidOptions& options, int sectors) {
  const double turn = std::abs(options.twist_rad_per_mm) * segment.length_mm;
  const double bands = std::ceil(turn / (2 * std::numbers::pi / sectors));
  return options.refinement == 0 ? bands : std::max(1.0, bands) * (1 << options.refinement);
}

// A helix is steepest at the smallest radius: its rise stays, its way around shrinks.
double steepest_slant(const Segment& segment) {
  if (has_curved_outlines(*segment.lattice)) return 1;
  const double shrunk = segment.liner_outer_radius_mm() / segment.lattice_mid_radius_mm();
  double steepest = 0;
  for (const Grid& grid : segment.lattice->grids) {
    if (grid.angle_deg == 90) continue;
    const double angle = grid.angle_rad();
    const double rise = std::sin(angle);
    steepest = std::max(steepest, rise / std::hypot(rise, shrunk * std::cos(angle)));
  }
  return steepest;
}

LatticeCutting lattice_cutting(const Segment& segment, const SolidOptions& options) {
  const double growth = std::max({1.0, options.stretch_radius, options.stretch});
  const bool twisted = options.twist_rad_per_mm != 0 && !segment.lattice->grids.empty();
  return {lattice_budget(segment, options.tolerance_mm, growth, twisted),
          twisted ? 1 : steepest_slant(segment)};
}

}  // namespace latticast
