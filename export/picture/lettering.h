// SPDX-License-Identifier: GPL-3.0-or-later
// Lettering: texts and lines over a picture, in a stroke font of its own, so that the same picture
// has the same bytes on every machine.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "export/colour.h"
#include "export/picture/png_file.h"

namespace latticast {

/// One line of text. Letters of ASCII and the sign of multiplication have shapes; any other is a
/// box.
struct Lettering {
  std::string text;
  std::array<double, 2> at{};  ///< pixels from the upper left corner: the middle of its base line
  double height_px = 14;       ///< of capitals
  Colour colour{0.2, 0.2, 0.2};
};

double width_px(std::string_view text, double height_px);

/// Draws over what is there, in a white rim that keeps it legible. What lies outside is cut off.
void draw_text(Image& image, const Lettering& lettering);

/// A line of the given thickness, from one place to the other, in pixels.
void draw_line(Image& image, std::array<double, 2> from, std::array<double, 2> to,
               double thickness_px, const Colour& colour);

}  // namespace latticast
