// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/horseshoe.h"

#include <cmath>

#include <fmt/core.h>

#include "design/limits.h"
#include "design/table_reader.h"
#include "design/text/written_number.h"
#include "design/units.h"

namespace latticast {

Horseshoe Horseshoe::read(const Field& field, double strand_mm) {
  TableReader table = field.as_table("write horseshoe = { radius = 2.656, arc = 180 }");
  Horseshoe path;
  path.radius_mm = table.need("radius", "radius = 2.656").number(limits::length);
  path.arc_deg = table.may("arc").number_or(path.arc_deg, limits::horseshoe_arc);
  path.alternate = table.may("alternate").flag_or(path.alternate);
  table.refuse_unknown_keys();
  const double arcs = strand_mm / (2 * path.radius_mm * std::sin(0.5 * radians(path.arc_deg)));
  if (arcs > limits::links) {
    field.refuse(fmt::format("a strand must not have more than {} arcs; this one has {}",
                             limits::links, written(arcs, 6)),
                 "use a larger radius");
  }
  return path;
}

PathDescription Horseshoe::description() const {
  return {.name = key,
          .noun = "a horseshoe",
          .text = fmt::format("arcs of {} degrees, radius {} mm", written(arc_deg, 6),
                              written(radius_mm, 6)),
          .more = "arcs of a larger angle",
          .narrower = "arcs of a smaller radius",
          .parameters = {{"radius_mm", radius_mm}, {"arc_deg", arc_deg}, {"alternate", alternate}}};
}

}  // namespace latticast
