// SPDX-License-Identifier: GPL-3.0-or-later
// Turned pieces whose steps all stand on one plane: plugs, a core on its base.
#pragma once

#include <vector>

#include "geometry/solid/tube_solids.h"

namespace latticast {

/// From the step inside of it, or the bore, out to `radius_mm`: material over 0 <= z <= height.
struct Step {
  double radius_mm = 0;
  double height_mm = 0;
};

struct SteppedRod {
  double bore_radius_mm = 0;  ///< through the whole rod; 0: none
  std::vector<Step> steps;    ///< from the inside outwards, radii rising; at most 4
  double start_z_mm = 0;      ///< added to every z
  double chamfer_mm = 0;      ///< of the first step's upper rim
};

/// One piece, of genus 0, or 1 with a bore. Within the tolerance; the volume is exact.
/// Preconditions: radii rise from the bore's; sizes are positive; the chamfer is less than the
/// first step's height over the second one and than the wall around the bore.
Solid stepped_solid(const SteppedRod& rod, double tolerance_mm);

}  // namespace latticast
