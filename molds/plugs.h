// SPDX-License-Identifier: GPL-3.0-or-later
// What closes an open liner: plugs that are pressed and glued into its ends.
#pragma once

#include <vector>

#include "design/design.h"
#include "molds/mold_piece.h"

namespace latticast {

struct PlugOptions {
  double tolerance_mm = 0.01;  ///< chord error
  double tube_mm = 4;          ///< outer diameter of the air tube
  bool closed_end = false;  ///< the liner's upper end is closed: the inlet's plug alone is needed
};

/// "plug-inlet", with a bore for the tube, and "plug". Each stands on its flange at z = 0: 3 mm
/// thick, as wide as the liner, but at least 1.5 mm wider than the shaft. The shaft above it is 2 %
/// wider than the bore of the liner, 10 mm long or 2/5 of the segment if that is less, and has a
/// chamfer to lead it in. The bore is at most half as wide as the shaft; `use` states its diameter.
/// The sizes are those of the finished liner: no growth. Preconditions: sizes are positive.
std::vector<MoldPiece> end_plugs(const Segment& segment, const PlugOptions& options);

}  // namespace latticast
