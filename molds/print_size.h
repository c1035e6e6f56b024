// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a piece fits the printer.
#pragma once

#include <array>
#include <string>

#include "molds/mold_piece.h"

namespace latticast {

/// A piece's bounding box in printing pose: standing on its end, as in the mold; pieces that are
/// pulled sideways are turned so that their pull points along the width.
struct PrintSize {
  double width_mm = 0;
  double depth_mm = 0;
  double height_mm = 0;
};

PrintSize print_size(const MoldPiece& piece);

/// Why the piece cannot be printed on a bed of width, depth and height, and what to change; empty
/// where it can, perhaps after a quarter turn.
std::string bed_problem(const MoldPiece& piece, const std::array<double, 3>& bed_mm);

}  // namespace latticast
