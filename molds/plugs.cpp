// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/plugs.h"

#include <algorithm>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "molds/stepped_solid.h"

namespace latticast {
namespace {

constexpr double squeeze = 1.02;
constexpr double shaft_mm = 10;
constexpr double flange_mm = 3;
constexpr double shoulder_mm = 1.5;

Solid plug_solid(const Segment& segment, double bore_mm, double tolerance_mm) {
  const double shaft = squeeze * segment.inner_radius_mm();
  const double length = std::min(shaft_mm, 0.4 * segment.length_mm);
  const double flange = std::max(segment.liner_outer_radius_mm(), shaft + shoulder_mm);
  SteppedRod rod;
  rod.bore_radius_mm = 0.5 * bore_mm;
  rod.steps = {{shaft, flange_mm + length}, {flange, flange_mm}};
  rod.chamfer_mm = std::min({1.0, 0.25 * length, 0.25 * shaft});
  return stepped_solid(rod, std::min(tolerance_mm, 0.25 * rod.chamfer_mm));
}

}  // namespace

std::vector<MoldPiece> end_plugs(const Segment& segment, const PlugOptions& options) {
  const double bore = std::min(options.tube_mm, squeeze * segment.inner_radius_mm());
  std::vector<MoldPiece> plugs;
  plugs.push_back(
      {"plug-inlet", plug_solid(segment, bore, options.tolerance_mm),
       fmt::format("closes the end that is fed; bore for a tube of {} mm", written(bore, 3))});
  if (!options.closed_end) {
    plugs.push_back({"plug", plug_solid(segment, 0, options.tolerance_mm), "closes the other end"});
  }
  return plugs;
}

}  // namespace latticast
