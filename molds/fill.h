// SPDX-License-Identifier: GPL-3.0-or-later
// Filling of a lattice mold: where the liquid goes in, and where air would be trapped.
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

struct FillWish {
  std::vector<double> around_rad;  ///< where a high point all around the tube gets its vents
  double vent_spacing_mm = 30;     ///< along u, of vents at other wide ones
  double largest_bore_mm = 4;      ///< diameter
};

/// A high point is a place, level within 0.05 mm, from which every way through the cavity leads
/// down, and down by more than that before it leads higher: rising liquid shuts air in there. Bores
/// stay inside the strands where they fit: vents up to 1.5 mm and 0.6 of the strand's width, sprues
/// up to 4 mm and 0.9 of it. A level ceiling that goes on to a higher place is no high point.
/// Throws GeometryError as unite does (region.h).
FillPlan plan_fill(const Pattern& strands, const FillWish& wish);

}  // namespace latticast
