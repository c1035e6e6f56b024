// SPDX-License-Identifier: GPL-3.0-or-later
// Orientation of a printed piece, and whether it fits the bed.
#pragma once

#include <array>
#include <string>

#include "molds/mold_piece.h"

namespace latticast {

/// The piece as it is printed, standing on z = 0 with the middle of its bounding box over the
/// origin: on its end, as in the mold, but for a cap, which lies on its outer face; pieces that are
/// pulled sideways are turned so that their pull points along x. Nothing then hangs over but the
/// upper edges of strap grooves and of flanges' steps. Proper motions only: what is sound stays so,
/// up to rounding. Precondition: the piece's mesh is not empty.
TriangleMesh printing_pose(const MoldPiece& piece);

/// Bounding box in printing pose.
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
