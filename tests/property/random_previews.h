// SPDX-License-Identifier: GPL-3.0-or-later
// Random designs under pressure: every moved mesh is welded as a file would hold it, and audited.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace latticast {

/// What came of a design's previews.
struct PreviewTrial {
  std::string design;  ///< its text
  bool drawn = false;  ///< false: refused before anything was moved, see `refusal`
  std::string refusal;
  int meshes = 0;                   ///< moved and audited
  std::vector<std::string> faults;  ///< a line for each mesh that fails
};

/// Five pressures, from a fifth to 19/20 of where the branch ends, or of 200 kPa if it ends beyond.
/// A design that was written with a mistake counts as refused.
PreviewTrial try_previews(std::uint64_t seed);

}  // namespace latticast
