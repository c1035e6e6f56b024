// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the drawn strands: they are printed, or cut as grooves into a printed mold.
#pragma once

#include <string>
#include <vector>

#include "design/design.h"

namespace latticast {

/// The printer's smallest sizes, as the design states them or as its process is commonly given:
/// fdm 0.8 mm walls (two lines of a 0.4 mm nozzle) and 0.4 mm gaps; sla 0.4 mm and 0.3 mm.
double least_wall_mm(const Printer& printer);
double least_gap_mm(const Printer& printer);

/// A printed strand is a wall and what lies between strands a gap; of a grooved mold it is the
/// other way round.
struct LatticeUse {
  bool grooved = false;
  double least_strand_mm = 0;
  double least_between_mm = 0;
  bool between_is_stated = false;  ///< least_between_mm is from the design file
  bool free_standing = false;      ///< printed by itself, not on a rod or as a groove

  /// "", or "lattice-mold " before the name of a part.
  std::string part(const std::string& name) const;
  std::string strand_word() const;   ///< "strand" or "groove"
  std::string between_word() const;  ///< "gap" or "land"
  std::string strand_limit() const;  ///< "least wall" or "least gap"
  std::string between_limit() const;
};

/// Printed with make.lattice and for a replica mold, whose pattern is printed; grooved with a
/// direct one. A design that makes nothing yet is looked at as if its lattice were printed. Empty
/// where only other things are made.
std::vector<LatticeUse> lattice_uses(const Design& design);

}  // namespace latticast
