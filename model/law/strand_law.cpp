// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/law/strand_law.h"

#include <utility>

namespace latticast {

StrandLaw::StrandLaw(const LinkShape& shape, double rest_chord_mm, double force_unit_n,
                     ForceTable table)
    : shape_(shape),
      table_(std::move(table)),
      rest_chord_mm_(rest_chord_mm),
      force_unit_n_(force_unit_n),
      energy_unit_nmm_(force_unit_n * rest_chord_mm) {}

std::optional<LinkState> StrandLaw::at(double strain) const {
  const std::optional<ForceTable::State> state = table_.at(strain);
  if (!state) return {};
  return LinkState{energy_unit_nmm_ * state->energy, force_unit_n_ * state->force,
                   force_unit_n_ * state->slope, state->error};
}

StrainRange link_range(double full_extension) {
  return {-0.3, full_extension + 0.5};
}

const StrainRange& checked_range(const StrainRange& range, const StrainRange& widest,
                                 std::string_view path_name) {
  const bool holds_rest = range.lowest <= 0 && range.highest >= 0 && range.lowest < range.highest;
  if (!holds_rest || range.lowest < widest.lowest || range.highest > widest.highest) {
    throw LinkOutOfScope(path_name,
                         "a " + std::string(path_name) +
                             "'s strains must hold 0 and lie from -0.3 to full extension + 0.5");
  }
  return range;
}

}  // namespace latticast
