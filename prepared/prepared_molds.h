// SPDX-License-Identifier: GPL-3.0-or-later
// The molds that a design's [make] asks for, planned and made once for checks, files and pictures.
#pragma once

#include <cstddef>
#include <map>

#include "design/design.h"
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#include "prepared/prepared_lattices.h"

namespace latticast {

/// For one thread at a time. Design and lattices must outlive it.
class PreparedMolds {
 public:
  PreparedMolds(const Design& design, PreparedLattices& lattices)
      : design_(design), lattices_(lattices) {}

  /// plan_lattice_mold() with the design's options. Preconditions of this and the next: the design
  /// asks for a lattice mold and the segment has a lattice. Throws as the functions named do.
  const LatticeMoldPlan& lattice_mold_plan(std::size_t segment);

  /// lattice_mold() or replica_mold(), as the design asks.
  const Mold& lattice_mold(std::size_t segment);

  /// liner_mold() with the design's options. Precondition: the design asks for one.
  const Mold& liner_mold(std::size_t segment);

 private:
  const Design& design_;
  PreparedLattices& lattices_;
  std::map<std::size_t, LatticeMoldPlan> plans_;
  std::map<std::size_t, Mold> lattice_molds_;
  std::map<std::size_t, Mold> liner_molds_;
};

}  // namespace latticast
