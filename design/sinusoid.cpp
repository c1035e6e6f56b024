// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/sinusoid.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "design/limits.h"
#include "design/table_reader.h"
#include "design/text/written_number.h"

namespace latticast {

Sinusoid Sinusoid::read(const Field& field, double /*strand_mm*/) {
  TableReader table = field.as_table("write sinusoid = { amplitude = 2, waves = 8 }");
  Sinusoid path;
  path.amplitude_mm = table.need("amplitude", "amplitude = 2").number(limits::length);
  const Field waves = table.need("waves", "waves = 8");
  path.waves = waves.number(limits::waves);
  if (2 * path.waves != std::round(2 * path.waves) && !std::isnan(path.waves)) {
    waves.refuse("must be a whole or half number, so that the strand ends on its chord line",
                 fmt::format("write waves = {}",
                             written(std::max(0.5, 0.5 * std::round(2 * path.waves)), 6)));
  }
  table.refuse_unknown_keys();
  return path;
}

PathDescription Sinusoid::description() const {
  return {.name = key,
          .noun = "a sinusoid",
          .text = fmt::format("{} {} of amplitude {} mm", written(waves, 6),
                              waves == 1 ? "sine wave" : "sine waves", written(amplitude_mm, 6)),
          .more = "waves of a larger amplitude",
          .narrower = "waves of a smaller amplitude",
          .parameters = {{"amplitude_mm", amplitude_mm}, {"waves", waves}}};
}

}  // namespace latticast
