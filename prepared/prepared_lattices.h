// SPDX-License-Identifier: GPL-3.0-or-later
// The drawings of a design's lattices, one a segment.
#pragma once

#include <cstddef>
#include <map>

#include "design/design.h"
#include "geometry/solid/lattice_drawing.h"

namespace latticast {

/// For one thread at a time. The design must outlive it.
class PreparedLattices {
 public:
  explicit PreparedLattices(const Design& design) : design_(design) {}

  /// Precondition: the segment has a lattice.
  LatticeDrawing& of(std::size_t segment);

 private:
  const Design& design_;
  std::map<std::size_t, LatticeDrawing> drawings_;
};

}  // namespace latticast
