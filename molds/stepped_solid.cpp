// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/stepped_solid.h"

#include <algorithm>
#include <numbers>

#include "geometry/solid/layered_solid.h"

namespace latticast {

Solid stepped_solid(const SteppedRod& rod, double tolerance_mm) {
  LayeredTube tube;
  tube.drawn_radius_mm = rod.steps.back().radius_mm;
  tube.start_z_mm = rod.start_z_mm;
  for (const Step& step : rod.steps) tube.length_mm = std::max(tube.length_mm, step.height_mm);
  const double around = 2 * std::numbers::pi * tube.drawn_radius_mm;
  double floor = rod.bore_radius_mm;
  for (const Step& step : rod.steps) {
    const Strand band = drawn_band(tube.drawn_radius_mm, 0, step.height_mm);
    tube.sheets.push_back({around, tube.length_mm, {band}});
    tube.layers.push_back({floor, step.radius_mm});
    floor = step.radius_mm;
  }
  tube.filling = [](unsigned sheets) { return Layers{sheets}; };

  const Step& first = rod.steps.front();
  if (rod.chamfer_mm > 0) {
    tube.cuts_mm = {first.height_mm - rod.chamfer_mm};
    tolerance_mm = chamfer_tolerance_mm(tolerance_mm, first.radius_mm);
  }
  Solid solid = layered_solid(tube, tolerance_mm);
  if (rod.chamfer_mm > 0) {
    chamfer(solid, rod.start_z_mm + first.height_mm, first.radius_mm, rod.chamfer_mm);
  }
  return solid;
}

}  // namespace latticast
