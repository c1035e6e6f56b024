// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/lettering.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "export/picture/stroke_font.h"

namespace latticast {
namespace {

using Pixel = std::array<double, 2>;

constexpr double grid_height = font_capital - font_baseline;
constexpr double stroke_share = 0.13;  // of the capitals' height
constexpr double rim_share = 0.2;      // likewise, beyond the stroke

struct Stroke {
  Pixel from;
  Pixel to;
};

double distance_from(const Stroke& segment, Pixel at) {
  const double x = segment.to[0] - segment.from[0];
  const double y = segment.to[1] - segment.from[1];
  const double square = x * x + y * y;
  const double along =
      square > 0 ? ((at[0] - segment.from[0]) * x + (at[1] - segment.from[1]) * y) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(at[0] - segment.from[0] - part * x, at[1] - segment.from[1] - part * y);
}

void lay(Image& image, int column, int row, const Colour& colour, double cover) {
  std::uint8_t* pixel =
      image.rgba.data() + 4 * (static_cast<std::size_t>(row) * image.width + column);
  const double below = pixel[3] / 255.0 * (1 - cover);
  const double opacity = cover + below;
  const std::array<double, 3> over{colour.red, colour.green, colour.blue};
  for (int i = 0; i < 3; ++i) {
    const double mixed = (255 * over[i] * cover + pixel[i] * below) / opacity;
    pixel[i] = static_cast<std::uint8_t>(std::lround(mixed));
  }
  pixel[3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
}

// All of them as one shape, so that they do not darken where they cross.
void draw_strokes(Image& image, const std::vector<Stroke>& segments, double half_px,
                  const Colour& colour) {
  Pixel low{HUGE_VAL, HUGE_VAL};
  Pixel high{-HUGE_VAL, -HUGE_VAL};
  for (const Stroke& segment : segments) {
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min({low[axis], segment.from[axis], segment.to[axis]});
      high[axis] = std::max({high[axis], segment.from[axis], segment.to[axis]});
    }
  }
  const double reach = half_px + 1;
  const auto clamped = [](double x, int most) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most)));
  };
  for (int row = clamped(low[1] - reach, image.height);
       row < clamped(high[1] + reach + 1, image.height); ++row) {
    for (int column = clamped(low[0] - reach, image.width);
         column < clamped(high[0] + reach + 1, image.width); ++column) {
      double nearest = HUGE_VAL;
      for (const Stroke& segment : segments) {
        nearest = std::min(nearest, distance_from(segment, {column + 0.5, row + 0.5}));
      }
      const double cover = std::clamp(half_px + 0.5 - nearest, 0.0, 1.0);
      if (cover > 0) lay(image, column, row, colour, cover);
    }
  }
}

// A letter of UTF-8 text, and how many bytes it has.
struct Glyph {
  std::string_view strokes;
  std::size_t bytes = 1;
};

Glyph first_letter(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return {strokes_of(text.front()), 1};
  if (text.starts_with("\xC3\x97")) return {strokes_of_times, 2};
  std::size_t bytes = 1;
  while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) ++bytes;
  return {strokes_of_box, bytes};
}

std::size_t letters_in(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); text.remove_prefix(first_letter(text).bytes)) ++count;
  return count;
}

std::vector<Stroke> segments_of(std::string_view text, Pixel left, double unit) {
  std::vector<Stroke> segments;
  for (; !text.empty(); left[0] += font_advance * unit) {
    const Glyph letter = first_letter(text);
    text.remove_prefix(letter.bytes);
    const std::string_view strokes = letter.strokes;
    const auto place = [&](std::size_t i) {
      return Pixel{left[0] + (strokes[i] - '0') * unit,
                   left[1] - (strokes[i + 1] - '0' - font_baseline) * unit};
    };
    for (std::size_t i = 0; i + 3 < strokes.size(); i += strokes[i + 2] == ' ' ? 3 : 2) {
      if (strokes[i + 2] != ' ') segments.push_back({place(i), place(i + 2)});
    }
  }
  return segments;
}

}  // namespace

double width_px(std::string_view text, double height_px) {
  const double letters = static_cast<double>(letters_in(text));
  return std::max(0.0, (letters - 1) * font_advance + 4) * height_px / grid_height;
}

void draw_text(Image& image, const Lettering& lettering) {
  const double unit = lettering.height_px / grid_height;
  const double left = lettering.at[0] - 0.5 * width_px(lettering.text, lettering.height_px);
  const std::vector<Stroke> segments = segments_of(lettering.text, {left, lettering.at[1]}, unit);
  const double half = 0.5 * stroke_share * lettering.height_px;
  draw_strokes(image, segments, half + rim_share * lettering.height_px, {1, 1, 1});
  draw_strokes(image, segments, half, lettering.colour);
}

void draw_line(Image& image, Pixel from, Pixel to, double thickness_px, const Colour& colour) {
  draw_strokes(image, {{from, to}}, 0.5 * thickness_px, colour);
}

}  // namespace latticast
