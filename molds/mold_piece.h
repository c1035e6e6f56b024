// SPDX-License-Identifier: GPL-3.0-or-later
// A mold as a list of pieces with notes, and how they fit together.
#pragma once

#include <string>
#include <vector>

#include "geometry/solid/tube_solids.h"

namespace latticast {

/// One printed piece, where it stands in the assembled mold: pouring position, axis along +z, the
/// cavity's bottom at z = 0, Theta as in the design.
struct MoldPiece {
  std::string name;  ///< "shell-1", "core", "base", "cap", "plug-inlet"
  Solid solid;
  std::string use;  ///< one line for the bill of pieces
  /// Taken off sideways in the direction Theta = pull_rad; otherwise along the axis.
  bool pulls_sideways = false;
  double pull_rad = 0;
};

/// How a mold's pieces fit.
struct MoldFit {
  double clearance_mm = 0.3;   ///< between pieces that are put together, on the diameter
  double wall_mm = 5;          ///< thinnest wall around the cavity
  double tolerance_mm = 0.01;  ///< chord error
  double growth = 1;           ///< of every cavity size, against the casting's shrinkage
};

/// How large the widest and the highest pieces are in printing pose, known before any is meshed.
struct MoldExtent {
  double plate_diameter_mm = 0;  ///< of base and cap
  double plate_height_mm = 0;    ///< of the base, with the core where it stands on it
  double core_diameter_mm = 0;
  double core_length_mm = 0;  ///< 0 where the core stands on the base
  double shell_height_mm = 0;
};

/// Pieces and what is poured between them.
struct Mold {
  std::vector<MoldPiece> pieces;
  double cavity_mm3 = 0;           ///< to be filled, sprues and vents left out
  std::vector<std::string> notes;  ///< what a maker must know, a sentence each
};

}  // namespace latticast
