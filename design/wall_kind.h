// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of wall that a segment can be predicted with, and their words in the design file and in
// answers (docs/model.md).
#pragma once

#include <array>

#include "design/word.h"

namespace latticast {

/// A wall in layers, its lattice a net of lines or plates bonded to the liner; a smeared wall; or
/// the drawn lattice itself in a unit cell.
enum class WallKind { layered, bonded, mixture, unit_cell };

inline constexpr std::array wall_kinds = {
    Word<WallKind>{"layered", WallKind::layered}, Word<WallKind>{"mixture", WallKind::mixture},
    Word<WallKind>{"bonded", WallKind::bonded}, Word<WallKind>{"unit-cell", WallKind::unit_cell}};

}  // namespace latticast
