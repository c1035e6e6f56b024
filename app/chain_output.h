// SPDX-License-Identifier: GPL-3.0-or-later
// Where a chain's tip and centre line are in each load case (docs/command-line.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/number_rows.h"
#include "model/chain.h"

namespace latticast {

/// One row a load case that has an equilibrium: case number from 1, pressures, the tip's place, the
/// directions of its axis and of its Theta = 0, the angle between its axis and the base's, the
/// twists of all segments together, the centre line's length, whether every segment is stable.
NumberRows tip_rows(const ChainResponse& chain, std::span<const Segment> segments);

/// One row a point of the centre line, 20 steps a segment: case number, pressures, distance from
/// the base along the rest chain, place.
NumberRows centre_line_rows(const ChainResponse& chain, std::span<const Segment> segments);

/// The cases that have no equilibrium, with the segments that have none and why.
std::vector<MissingRow> missing_cases(const ChainResponse& chain);

/// "121 of 121 cases; the tip is 0 to 24.1 mm off the base's axis and 200 to 262 mm above it".
std::string reach_summary(const ChainResponse& chain, std::span<const Segment> segments);

}  // namespace latticast
