// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_strand_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "design/limits.h"
#include "design/units.h"

namespace latticast {
namespace {

Horseshoe read_horseshoe(const Field& field, double strand_mm) {
  TableReader table = field.as_table("write horseshoe = { radius = 2.656, arc = 180 }");
  Horseshoe path;
  path.radius_mm = table.need("radius", "radius = 2.656").number(limits::length);
  path.arc_deg = table.may("arc").number_or(path.arc_deg, limits::horseshoe_arc);
  path.alternate = table.may("alternate").flag_or(path.alternate);
  table.refuse_unknown_keys();
  const double arcs = strand_mm / (2 * path.radius_mm * std::sin(0.5 * radians(path.arc_deg)));
  if (arcs > limits::links) {
    field.refuse(fmt::format("a strand must not have more than {} arcs; this one has {:.6g}",
                             limits::links, arcs),
                 "use a larger radius");
  }
  return path;
}

Sinusoid read_sinusoid(const Field& field) {
  TableReader table = field.as_table("write sinusoid = { amplitude = 2, waves = 8 }");
  Sinusoid path;
  path.amplitude_mm = table.need("amplitude", "amplitude = 2").number(limits::length);
  const Field waves = table.need("waves", "waves = 8");
  path.waves = waves.number(limits::waves);
  if (2 * path.waves != std::round(2 * path.waves) && !std::isnan(path.waves)) {
    waves.refuse(
        "must be a whole or half number, so that the strand ends on its chord line",
        fmt::format("write waves = {:g}", std::max(0.5, 0.5 * std::round(2 * path.waves))));
  }
  table.refuse_unknown_keys();
  return path;
}

}  // namespace

StrandPath read_strand_path(TableReader& table, const Segment& segment, double angle_deg) {
  const double strand_mm = segment.length_mm / std::sin(radians(angle_deg));
  const Field horseshoe = table.may("horseshoe");
  const Field sinusoid = table.may("sinusoid");
  if (horseshoe.present() && sinusoid.present()) {
    sinusoid.refuse("a strand follows one path, but horseshoe is given as well",
                    "keep horseshoe or sinusoid");
  }
  if (horseshoe.present()) return read_horseshoe(horseshoe, strand_mm);
  if (sinusoid.present()) return read_sinusoid(sinusoid);
  return StraightPath{};
}

}  // namespace latticast
