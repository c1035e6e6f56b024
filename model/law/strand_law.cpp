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

}  // namespace latticast
