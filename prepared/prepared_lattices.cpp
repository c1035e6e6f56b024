// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_lattices.h"

namespace latticast {

LatticeDrawing& PreparedLattices::of(std::size_t segment) {
  return drawings_.try_emplace(segment, design_.segments[segment]).first->second;
}

}  // namespace latticast
