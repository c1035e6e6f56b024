// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/flat/flat_drawing.h"

#include <algorithm>
#include <charconv>
#include <numbers>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "export/flat/flat_marks.h"

namespace latticast {
namespace {

constexpr double letters_along_sheet = 50;
constexpr double letter_width = 0.62;  // of its height, in usual fonts
constexpr double scale_bar_mm = 50;

std::string widths_text(const Grid& grid) {
  const auto [low, high] = std::minmax_element(grid.widths_mm.begin(), grid.widths_mm.end());
  if (*low == *high) return fmt::format("{} mm wide", written(*low, 6));
  return fmt::format("{} to {} mm wide", written(*low, 6), written(*high, 6));
}

std::string family_text(const Grid& grid, std::size_t index) {
  std::string text =
      fmt::format("grid {}: {} at {} degrees from the circumference, {}", index + 1,
                  grid.count() == 1 ? "one strand" : fmt::format("{} strands", grid.count()),
                  written(grid.angle_deg, 6), widths_text(grid));
  const std::string path = describe(grid.path).text;
  return path.empty() ? text : text + ", " + path;
}

void add_angles(const FlatDrawing& drawing, FlatMarks& marks) {
  const double letter = marks.letter_mm;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double x = 0.25 * quarter * drawing.width_mm;
    marks.lines.push_back({{x, -letter}, {x, drawing.height_mm + letter}});
    const std::string label = fmt::format("{}{}", quarter == 0 ? "Theta = " : "", 90 * quarter);
    marks.texts.push_back({{x, -2.5 * letter}, true, label});
  }
  marks.texts.push_back({{drawing.width_mm, -2.5 * letter}, true, "360 degrees"});
  const double beside = drawing.width_mm + 0.5 * letter;
  marks.texts.push_back({{beside, 0}, false, "z = 0"});
  marks.texts.push_back({{beside, drawing.height_mm - letter},
                         false,
                         fmt::format("z = {} mm", written(drawing.height_mm, 6))});
}

void add_scale_bar(const FlatDrawing& drawing, FlatMarks& marks) {
  const double letter = marks.letter_mm;
  const double length = std::min(scale_bar_mm, drawing.height_mm);
  const double y = -5 * letter;
  marks.lines.push_back({{0, y}, {length, y}});
  marks.lines.push_back({{0, y - 0.5 * letter}, {0, y + 0.5 * letter}});
  marks.lines.push_back({{length, y - 0.5 * letter}, {length, y + 0.5 * letter}});
  marks.texts.push_back(
      {{length + letter, y - 0.5 * letter}, false, fmt::format("{} mm", written(length, 6))});
}

void add_words(const FlatDrawing& drawing, FlatMarks& marks) {
  double y = -8 * marks.letter_mm;
  marks.texts.push_back({{0, y}, false, drawing.title});
  for (const std::string& note : drawing.notes) {
    y -= 1.6 * marks.letter_mm;
    marks.texts.push_back({{0, y}, false, note});
  }
}

void find_box(const FlatDrawing& drawing, FlatMarks& marks) {
  const double letter = marks.letter_mm;
  marks.low = {0, 0};
  marks.high = {drawing.width_mm, drawing.height_mm + letter};
  for (const MarkText& mark : marks.texts) {
    const double width = letter_width * letter * static_cast<double>(mark.text.size());
    const double left = mark.at[0] - (mark.centred ? 0.5 * width : 0);
    marks.low = {std::min(marks.low[0], left), std::min(marks.low[1], mark.at[1] - 0.5 * letter)};
    marks.high[0] = std::max(marks.high[0], left + width);
  }
  for (const MarkLine& mark : marks.lines) marks.high[0] = std::max(marks.high[0], mark.to[0]);
  for (int axis = 0; axis < 2; ++axis) {
    marks.low[axis] -= letter;
    marks.high[axis] += letter;
  }
}

}  // namespace

std::vector<std::string> drawing_notes(const Segment& segment) {
  const Lattice& lattice = *segment.lattice;
  const double radius = segment.lattice_mid_radius_mm();
  std::vector<std::string> notes{
      fmt::format("unrolled at mid radius {} mm: {} mm around, {} mm along", written(radius, 6),
                  written(2 * std::numbers::pi * radius, 6), written(segment.length_mm, 6)),
      "seen from outside, z upwards; the left edge joins the right one",
      fmt::format("sheet {} mm thick, rolled to an inner radius of {} mm",
                  written(lattice.thickness_mm, 6), written(segment.liner_outer_radius_mm(), 6))};
  if (lattice.rings) {
    notes.push_back(fmt::format("rings: {} mm wide", written(lattice.rings->width_mm, 6)));
  }
  for (std::size_t i = 0; i < lattice.grids.size(); ++i) {
    notes.push_back(family_text(lattice.grids[i], i));
  }
  if (lattice.fillet_mm > 0) {
    notes.push_back(fmt::format("fillets: {} mm", written(lattice.fillet_mm, 6)));
  }
  return notes;
}

FlatMarks flat_marks(const FlatDrawing& drawing) {
  FlatMarks marks;
  marks.letter_mm = std::max(drawing.width_mm, drawing.height_mm) / letters_along_sheet;
  add_angles(drawing, marks);
  add_scale_bar(drawing, marks);
  add_words(drawing, marks);
  find_box(drawing, marks);
  return marks;
}

std::string exact_text(double value) {
  char text[400];  // the smallest doubles have more than 300 zeros after the point
  const auto end = std::to_chars(std::begin(text), std::end(text), value, std::chars_format::fixed);
  return {std::begin(text), end.ptr};
}

}  // namespace latticast
