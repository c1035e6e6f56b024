// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_lattices.h"

#include "design/design.h"
#include "geometry/solid/lattice_drawing.h"

namespace latticast {

PreparedLattices::PreparedLattices(const Design& design) : design_(design) {}
PreparedLattices::~PreparedLattices() = default;

LatticeDrawing& PreparedLattices::of(std::size_t segment) {
  std::unique_ptr<LatticeDrawing>& drawing = drawings_[segment];
  if (!drawing) {
    drawing =
        std::make_unique<LatticeDrawing>(design_.segments[segment], design_.output.tolerance_mm);
  }
  return *drawing;
}

}  // namespace latticast
