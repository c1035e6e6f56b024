// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/core.h>

#include "export/flat/flat_drawing.h"
#include "export/flat/flat_marks.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

constexpr double hairline_mm = 0.05;
constexpr double finest_hairline = 0.05;  // of a letter's height, on small sheets

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

// Coordinates of the paper: y downwards, from the sheet's upper end.
class SvgWriter {
 public:
  explicit SvgWriter(const FlatDrawing& drawing) : drawing_(drawing), marks_(flat_marks(drawing)) {}

  std::string run() {
    begin();
    open_group("sheet", "#0000ff");
    text_ += fmt::format("<path d=\"M0 0 H{} V{} H0 Z\"/>\n", exact_text(drawing_.width_mm),
                         exact_text(drawing_.height_mm));
    text_ += "</g>\n";
    open_group("marks", "#808080");
    for (const MarkLine& line : marks_.lines) add(line);
    for (const MarkText& mark : marks_.texts) add(mark);
    text_ += "</g>\n";
    open_group("lattice", "#000000");
    for (const DrawnPiece& piece : drawing_.pieces) add(piece);
    text_ += "</g>\n</svg>\n";
    return std::move(text_);
  }

 private:
  std::string down(double y) const { return exact_text(drawing_.height_mm - y); }

  void begin() {
    const double width = marks_.high[0] - marks_.low[0];
    const double height = marks_.high[1] - marks_.low[1];
    text_ += fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
        "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n<title>{4}</title>\n",
        exact_text(width), exact_text(height), exact_text(marks_.low[0]), down(marks_.high[1]),
        escaped(drawing_.title));
  }

  void open_group(std::string_view name, std::string_view colour) {
    text_ += fmt::format(
        "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\" fill=\"none\" "
        "fill-rule=\"evenodd\" stroke=\"{1}\" stroke-width=\"{2}\">\n",
        name, colour, exact_text(std::min(hairline_mm, finest_hairline * marks_.letter_mm)));
  }

  void add(const MarkLine& line) {
    text_ += fmt::format("<path d=\"M{} {} L{} {}\"/>\n", exact_text(line.from[0]),
                         down(line.from[1]), exact_text(line.to[0]), down(line.to[1]));
  }

  void add(const MarkText& mark) {
    text_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\"{} fill=\"#808080\" "
        "stroke=\"none\">{}</text>\n",
        exact_text(mark.at[0]), down(mark.at[1]), exact_text(marks_.letter_mm),
        mark.centred ? " text-anchor=\"middle\"" : "", escaped(mark.text));
  }

  void add(const DrawnPiece& piece) {
    text_ += "<path d=\"";
    for (const DrawnOutline& outline : piece.outlines) {
      char command = 'M';
      for (const auto& [x, y] : outline) {
        text_ += fmt::format("{}{} {} ", command, exact_text(x), down(y));
        command = 'L';
      }
      text_ += 'Z';
    }
    text_ += "\"/>\n";
  }

  const FlatDrawing& drawing_;
  FlatMarks marks_;
  std::string text_;
};

}  // namespace

void write_svg(const std::filesystem::path& target, const FlatDrawing& drawing) {
  write_file_atomically(target, SvgWriter(drawing).run());
}

}  // namespace latticast
