// SPDX-License-Identifier: GPL-3.0-or-later
// Letters as strokes on a grid of 5 by 9 points.
#pragma once

#include <string_view>

namespace latticast {

/// Rows of the grid: 0 under descenders, on which letters stand, as high as small ones, as
/// capitals.
inline constexpr double font_baseline = 2;
inline constexpr double font_capital = 8;
inline constexpr double font_advance = 5.6;  ///< from one letter's left edge to the next one's

/// Strokes between blanks; a stroke is a row of points, each a digit to the right and one up. Empty
/// for a blank; a box for what has no shape.
std::string_view strokes_of(char letter);

inline constexpr std::string_view strokes_of_times = "0347 0743";
inline constexpr std::string_view strokes_of_box = "0208484202";

}  // namespace latticast
