// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tip of a chain can get when every segment has its own pressures.
#pragma once

#include <span>
#include <vector>

#include "model/shape.h"

namespace latticast {

/// The tip under one combination of pressures, one per segment.
struct TipPlace {
  std::vector<double> pressures_kpa;
  Frame tip;
};

/// The chain's tip for every combination of `pressures_kpa[i]` of segment i, the last segment's
/// pressure running fastest. Each segment is predicted once per pressure; combinations only compose
/// frames. Combinations in which a segment has no equilibrium are left out. Throws
/// std::invalid_argument when the counts differ or are zero, and as predict does.
std::vector<TipPlace> workspace(std::span<const PreparedSegment> segments,
                                std::span<const std::vector<double>> pressures_kpa);

}  // namespace latticast
