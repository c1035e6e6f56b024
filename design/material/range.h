// SPDX-License-Identifier: GPL-3.0-or-later
// Interval of real numbers that a key of the design file or of a material may take.
#pragma once

namespace latticast {

/// Which of its ends belong to a range.
enum class RangeEnds { both, low, neither };

/// The numbers from `low` to `high`. Not a number is outside.
struct Range {
  double low = 0;
  double high = 0;
  const char* unit = "";  ///< empty: a pure number
  RangeEnds ends = RangeEnds::both;

  bool contains(double x) const {
    const bool above = ends == RangeEnds::neither ? x > low : x >= low;
    return above && (ends == RangeEnds::both ? x <= high : x < high);
  }
};

}  // namespace latticast
