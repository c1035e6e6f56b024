// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of layers and of sheets, and which layers the sheets make material.
#pragma once

#include <cstdint>
#include <functional>

namespace latticast {

/// A set of layers, bit i for layer i. A relief is made of layers one above the other (relief.h);
/// the union of a pattern's strands has a single one, layer 0.
using Layers = std::uint32_t;

/// The set of one layer, or of one sheet, alone. Layers and sheets are named by enumerators.
template <class Index>
constexpr std::uint32_t only(Index index) {
  return 1U << static_cast<unsigned>(index);
}

/// Does a set of layers or of sheets hold this one?
template <class Index>
constexpr bool has(std::uint32_t set, Index index) {
  return (set & only(index)) != 0;
}

/// Which layers are material at a place, from the sheets that cover it there (bit s for sheet s).
/// None where no sheet does: what lies beyond the ends is such a place.
using Filling = std::function<Layers(unsigned sheets)>;

}  // namespace latticast
