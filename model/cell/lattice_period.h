// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest period of a segment's lattice along and around the tube: what a unit cell has to hold
// (docs/unit-cell.md#period). mm, rad.
#pragma once

#include <optional>
#include <string>

#include "design/design.h"

namespace latticast {

/// The lattice between two heights of `drawn`, over 1/repeats of the circumference, fills the tube
/// by turns about its axis and by the shift (u, from) -> (u + shift, to).
struct LatticePeriod {
  Segment drawn;  ///< the segment, as long as a drawing that holds the period, links and rings as
                  ///< it has them
  double from_mm = 0;
  double to_mm = 0;
  int repeats = 1;
  double shift_mm = 0;    ///< at the lattice's mid radius
  bool mirrored = false;  ///< both heights are mirror planes: half a period is enough
  std::string assumed;    ///< what had to be changed to find a period; mostly empty
};

struct FoundPeriod {
  std::optional<LatticePeriod> period;
  std::string reason;  ///< why there is none
};

/// In how many equal sectors the families' strands come. Precondition: a segment with a lattice.
int equal_sectors(const Segment& segment);

/// Rings and links repeat together after a few pitches, or the rings are set to the links; families
/// of different angles repeat together or are refused. Precondition: a segment with strands.
FoundPeriod find_period(const Segment& segment);

}  // namespace latticast
