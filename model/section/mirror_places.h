// SPDX-License-Identifier: GPL-3.0-or-later
// Planes that mirror the widths of strands around a tube.
#pragma once

#include <span>
#include <vector>

namespace latticast {

/// Entry p of as many as there are strands: whether the plane through Theta = pi p/count
/// mirrors them, that is widths[j] == widths[(p - j) mod count] for all j. Time and memory grow
/// with the count. Widths that are not numbers mirror nothing.
std::vector<bool> mirror_places(std::span<const double> widths);

}  // namespace latticast
