// SPDX-License-Identifier: GPL-3.0-or-later
// Interval of real numbers that a key of the design file or of a material may take.
#pragma once

namespace latticast {

/// The numbers from `low` to `high`; with `ends_excluded`, neither of the two. Not a number is
/// outside.
struct Range {
  double low = 0;
  double high = 0;
  const char* unit = "";  ///< empty: a pure number
  bool ends_excluded = false;

  bool contains(double x) const {
    return ends_excluded ? x > low && x < high : x >= low && x <= high;
  }
};

}  // namespace latticast
