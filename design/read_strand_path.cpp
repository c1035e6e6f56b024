// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_strand_path.h"

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

}  // namespace

StrandPath read_strand_path(TableReader& table, const Segment& segment, double angle_deg) {
  const double strand_mm = segment.length_mm / std::sin(radians(angle_deg));
  const Field horseshoe = table.may("horseshoe");
  if (horseshoe.present()) return read_horseshoe(horseshoe, strand_mm);
  return StraightPath{};
}

}  // namespace latticast
