// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/strand_path.h"

#include <fmt/core.h>

namespace latticast {
namespace {

PathDescription description(const StraightPath& /*path*/) {
  return {.name = "straight",
          .noun = "a straight strip",
          .text = {},
          .more = "strands nearer to the circumference",
          .narrower = {},
          .parameters = {}};
}

PathDescription description(const Horseshoe& path) {
  return {
      .name = "horseshoe",
      .noun = "a horseshoe",
      .text = fmt::format("arcs of {:.6g} degrees, radius {:.6g} mm", path.arc_deg, path.radius_mm),
      .more = "arcs of a larger angle",
      .narrower = "arcs of a smaller radius",
      .parameters = {
          {"radius_mm", path.radius_mm}, {"arc_deg", path.arc_deg}, {"alternate", path.alternate}}};
}

PathDescription description(const Sinusoid& path) {
  return {.name = "sinusoid",
          .noun = "a sinusoid",
          .text = fmt::format("{:.6g} {} of amplitude {:.6g} mm", path.waves,
                              path.waves == 1 ? "sine wave" : "sine waves", path.amplitude_mm),
          .more = "waves of a larger amplitude",
          .narrower = "waves of a smaller amplitude",
          .parameters = {{"amplitude_mm", path.amplitude_mm}, {"waves", path.waves}}};
}

StrandPath larger(const StraightPath& path, double /*factor*/) {
  return path;
}

StrandPath larger(Horseshoe path, double factor) {
  path.radius_mm *= factor;
  return path;
}

StrandPath larger(Sinusoid path, double factor) {
  path.amplitude_mm *= factor;
  return path;
}

}  // namespace

bool is_curved(const StrandPath& path) {
  return !std::holds_alternative<StraightPath>(path);
}

PathDescription describe(const StrandPath& path) {
  return std::visit([](const auto& kind) { return description(kind); }, path);
}

StrandPath scaled(const StrandPath& path, double factor) {
  return std::visit([&](const auto& kind) { return larger(kind, factor); }, path);
}

}  // namespace latticast
