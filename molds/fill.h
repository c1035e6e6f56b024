// SPDX-License-Identifier: GPL-3.0-or-later
// How a lattice mold fills: where the liquid goes in, and where air would be trapped.
#pragma once

#include <vector>

#include "geometry/pattern/pattern.h"

namespace latticast {

/// A round opening through the shell, given in the unrolled plane.
struct Bore {
  PlanePoint middle;
  double radius_mm = 0;
};

/// The cavity between strands, in pouring position: z is up.
struct FillPlan {
  int cavities = 0;                     ///< connected parts
  double area_mm2 = 0;                  ///< of the united strands
  std::vector<PlanePoint> high_points;  ///< the middle of every one
  std::vector<Bore> vents;              ///< at least one at every high point
  std::vector<Bore> sprues;             ///< one a cavity, at its lowest point
};

/// A high point is a place, level within 0.05 mm, from which every way through the cavity leads
/// down, and down by more than that before it leads higher: rising liquid shuts air in there. Wide
/// ones get a vent for every `vent_spacing_mm` along u, those that run all the way around one at
/// each of `around_rad`. Bores stay inside the strands where they fit: vents up to 1.5 mm and 0.6
/// of the strand's width, sprues up to 4 mm and 0.9 of it. A level ceiling that goes on to a higher
/// place is no high point. Throws GeometryError as unite does (region.h).
FillPlan plan_fill(const Pattern& strands, const std::vector<double>& around_rad,
                   double vent_spacing_mm);

}  // namespace latticast
