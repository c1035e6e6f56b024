// SPDX-License-Identifier: GPL-3.0-or-later
// Marks around a flat drawing, lines and texts, the same for every format.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "export/flat/flat_drawing.h"

namespace latticast {

struct MarkLine {
  std::array<double, 2> from;
  std::array<double, 2> to;
};

struct MarkText {
  std::array<double, 2> at;  ///< on the base line
  bool centred = false;      ///< `at` is its middle, otherwise its beginning
  std::string text;
};

/// In the drawing's coordinates, y up.
struct FlatMarks {
  double letter_mm = 0;  ///< height of letters
  std::vector<MarkLine> lines;
  std::vector<MarkText> texts;
  std::array<double, 2> low;   ///< a box around drawing and marks; texts are taken to be as wide as
  std::array<double, 2> high;  ///< those of usual fonts
};

FlatMarks flat_marks(const FlatDrawing& drawing);

/// The shortest decimal text that reads back as the same double, without exponent.
std::string exact_text(double value);

}  // namespace latticast
