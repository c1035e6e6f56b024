// SPDX-License-Identifier: GPL-3.0-or-later
// The molds that [make] may name. Rules: docs/design-file.md.
#pragma once

#include <optional>
#include <vector>

#include "design/design.h"
#include "design/table_reader.h"

namespace latticast {

/// What molds must suit. Numbers that were refused are NaN, and rules that need them stay silent.
struct MoldSurroundings {
  const std::vector<Segment>& segments;
  double clearance_mm = 0;  ///< of the printer
};

/// make.lattice_mold; absent where it is not named. Some segment must have a lattice; the wall is
/// thicker than the clearance and, where grooves are cut into it, than every lattice.
std::optional<LatticeMold> read_lattice_mold(const Field& field, const MoldSurroundings& around);

/// make.liner_mold; absent where it is not named. Flanges and the keyed mold need a lattice on
/// every segment, and exclude each other; a closed liner is longer than it is thick.
std::optional<LinerMold> read_liner_mold(const Field& field, const MoldSurroundings& around);

}  // namespace latticast
