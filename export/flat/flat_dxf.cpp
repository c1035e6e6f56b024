// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/core.h>

#include "export/flat/flat_drawing.h"
#include "export/flat/flat_marks.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

constexpr std::uint32_t replacement = '?';

// The next letter of a UTF-8 text.
std::uint32_t next_letter(const std::string& text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  std::uint32_t letter = lead & (0x3FU >> more);
  for (int i = 0; i < more && at < text.size(); ++i) {
    letter = letter << 6 | (static_cast<unsigned char>(text[at++]) & 0x3FU);
  }
  return letter;
}

std::string in_ascii(const std::string& text) {
  std::string ascii;
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t letter = next_letter(text, at);
    if (letter > 0xFFFF) letter = replacement;
    ascii += letter < 0x80 ? std::string(1, static_cast<char>(letter))
                           : fmt::format("\\U+{:04X}", letter);
  }
  return ascii;
}

// A DXF file is a list of tagged values, a line for each tag's number and one for the value. From
// AutoCAD 2000 on every object has a handle, its owner's and the names of its classes.
class DxfWriter {
 public:
  explicit DxfWriter(const FlatDrawing& drawing)
      : drawing_(drawing),
        marks_(flat_marks(drawing)),
        shift_{std::ceil(-marks_.low[0]), std::ceil(-marks_.low[1])} {}

  std::string run() {
    add_tables();
    add_blocks();
    add_entities();
    add_objects();
    const std::string body = std::move(text_);
    text_.clear();
    add_header();  // tells the first free handle
    return text_ + body + "0\nEOF\n";
  }

 private:
  static constexpr int model_space = 1;  // handles of what others point to
  static constexpr int paper_space = 2;
  static constexpr int root_dictionary = 3;

  void tag(int code, std::string_view value) { text_ += fmt::format("{}\n{}\n", code, value); }
  void tag(int code, int value) { tag(code, std::to_string(value)); }
  void number(int code, double value) { tag(code, exact_text(value)); }

  // Where the drawing's own x or y stands in the file.
  double shifted(int axis, double coordinate) const { return coordinate + shift_[axis]; }

  void point(int code, const std::array<double, 2>& at) {
    number(code, shifted(0, at[0]));
    number(code + 10, shifted(1, at[1]));
    number(code + 20, 0);
  }

  void origin(int code) {
    for (int axis = 0; axis < 3; ++axis) number(code + 10 * axis, 0);
  }

  void handle(int value) { tag(5, fmt::format("{:X}", value)); }
  int new_handle() {
    handle(next_handle_);
    return next_handle_++;
  }
  void owner(int value) { tag(330, fmt::format("{:X}", value)); }

  void begin_section(std::string_view name) {
    tag(0, "SECTION");
    tag(2, name);
  }
  void end_section() { tag(0, "ENDSEC"); }

  void add_header() {
    begin_section("HEADER");
    const auto variable = [this](std::string_view name) { tag(9, name); };
    variable("$ACADVER");
    tag(1, "AC1015");
    variable("$DWGCODEPAGE");
    tag(3, "ANSI_1252");
    variable("$INSUNITS");
    tag(70, 4);
    variable("$MEASUREMENT");
    tag(70, 1);
    variable("$EXTMIN");
    point(10, marks_.low);
    variable("$EXTMAX");
    point(10, marks_.high);
    variable("$HANDSEED");
    handle(next_handle_);
    end_section();
  }

  // Returns the table's handle, which its records name as their owner.
  int begin_table(std::string_view name, int records) {
    tag(0, "TABLE");
    tag(2, name);
    const int own = new_handle();
    owner(0);
    tag(100, "AcDbSymbolTable");
    tag(70, records);
    return own;
  }

  void begin_record(std::string_view table, std::string_view kind, int own, std::string_view name,
                    int known_handle = 0) {
    tag(0, table);
    if (known_handle != 0) handle(known_handle);
    if (known_handle == 0) new_handle();
    owner(own);
    tag(100, "AcDbSymbolTableRecord");
    tag(100, kind);
    tag(2, name);
  }

  void end_table() { tag(0, "ENDTAB"); }

  void add_tables() {
    begin_section("TABLES");
    add_view();
    add_line_types();
    add_layers();
    add_letter_style();
    for (const std::string_view empty : {"VIEW", "UCS"}) {
      begin_table(empty, 0);
      end_table();
    }
    const int programs = begin_table("APPID", 1);
    begin_record("APPID", "AcDbRegAppTableRecord", programs, "ACAD");
    tag(70, 0);
    end_table();
    begin_table("DIMSTYLE", 0);
    tag(100, "AcDbDimStyleTable");
    end_table();
    const int blocks = begin_table("BLOCK_RECORD", 2);
    begin_record("BLOCK_RECORD", "AcDbBlockTableRecord", blocks, "*Model_Space", model_space);
    begin_record("BLOCK_RECORD", "AcDbBlockTableRecord", blocks, "*Paper_Space", paper_space);
    end_table();
    end_section();
  }

  // All of the drawing on the screen.
  void add_view() {
    const double width = marks_.high[0] - marks_.low[0];
    const double height = marks_.high[1] - marks_.low[1];
    const int views = begin_table("VPORT", 1);
    begin_record("VPORT", "AcDbViewportTableRecord", views, "*Active");
    tag(70, 0);
    number(10, 0);
    number(20, 0);
    number(11, 1);
    number(21, 1);
    number(12, shifted(0, 0.5 * (marks_.low[0] + marks_.high[0])));
    number(22, shifted(1, 0.5 * (marks_.low[1] + marks_.high[1])));
    number(40, height);
    number(41, width / height);
    end_table();
  }

  void add_line_types() {
    const int types = begin_table("LTYPE", 3);
    for (const std::string_view name : {"ByBlock", "ByLayer", "Continuous"}) {
      begin_record("LTYPE", "AcDbLinetypeTableRecord", types, name);
      tag(70, 0);
      tag(3, "");
      tag(72, 65);
      tag(73, 0);
      number(40, 0);
    }
    end_table();
  }

  void add_layers() {
    constexpr std::pair<std::string_view, int> layers[] = {
        {"0", 7}, {"LATTICE", 7}, {"SHEET", 5}, {"MARKS", 8}};
    const int table = begin_table("LAYER", static_cast<int>(std::size(layers)));
    for (const auto& [name, colour] : layers) {
      begin_record("LAYER", "AcDbLayerTableRecord", table, name);
      tag(70, 0);
      tag(62, colour);
      tag(6, "Continuous");
    }
    end_table();
  }

  void add_letter_style() {
    const int styles = begin_table("STYLE", 1);
    begin_record("STYLE", "AcDbTextStyleTableRecord", styles, "Standard");
    tag(70, 0);
    number(40, 0);
    number(41, 1);
    number(50, 0);
    tag(71, 0);
    number(42, marks_.letter_mm);
    tag(3, "txt");
    tag(4, "");
    end_table();
  }

  void add_blocks() {
    constexpr std::pair<std::string_view, int> blocks[] = {{"*Model_Space", model_space},
                                                           {"*Paper_Space", paper_space}};
    begin_section("BLOCKS");
    for (const auto& [name, record] : blocks) {
      begin_entity("BLOCK", "0", "AcDbBlockBegin", record);
      tag(2, name);
      tag(70, 0);
      origin(10);
      tag(3, name);
      tag(1, "");
      begin_entity("ENDBLK", "0", "AcDbBlockEnd", record);
    }
    end_section();
  }

  void begin_entity(std::string_view type, std::string_view layer, std::string_view kind,
                    int owned_by = model_space) {
    tag(0, type);
    new_handle();
    owner(owned_by);
    tag(100, "AcDbEntity");
    tag(8, layer);
    tag(100, kind);
  }

  void add_entities() {
    begin_section("ENTITIES");
    for (const DrawnPiece& piece : drawing_.pieces) {
      for (const DrawnOutline& outline : piece.outlines) add_outline(outline, "LATTICE");
    }
    const double right = drawing_.width_mm;
    const double top = drawing_.height_mm;
    add_outline({{0, 0}, {right, 0}, {right, top}, {0, top}}, "SHEET");
    for (const MarkLine& line : marks_.lines) {
      begin_entity("LINE", "MARKS", "AcDbLine");
      point(10, line.from);
      point(11, line.to);
    }
    for (const MarkText& mark : marks_.texts) add_text(mark);
    end_section();
  }

  void add_outline(const DrawnOutline& outline, std::string_view layer) {
    begin_entity("LWPOLYLINE", layer, "AcDbPolyline");
    tag(90, static_cast<int>(outline.size()));
    tag(70, 1);  // closed
    for (const auto& [x, y] : outline) {
      number(10, shifted(0, x));
      number(20, shifted(1, y));
    }
  }

  void add_text(const MarkText& mark) {
    begin_entity("TEXT", "MARKS", "AcDbText");
    point(10, mark.at);
    number(40, marks_.letter_mm);
    tag(1, in_ascii(mark.text));
    if (mark.centred) {
      tag(72, 1);
      point(11, mark.at);
    }
    tag(100, "AcDbText");
  }

  void add_objects() {
    begin_section("OBJECTS");
    const int groups = next_handle_++;
    begin_dictionary(root_dictionary, 0);
    tag(3, "ACAD_GROUP");
    tag(350, fmt::format("{:X}", groups));
    begin_dictionary(groups, root_dictionary);
    end_section();
  }

  void begin_dictionary(int own, int owned_by) {
    tag(0, "DICTIONARY");
    handle(own);
    owner(owned_by);
    tag(100, "AcDbDictionary");
    tag(281, 1);
  }

  const FlatDrawing& drawing_;
  FlatMarks marks_;
  std::array<double, 2> shift_;  // whole millimetres, after which nothing lies below 0
  std::string text_;
  int next_handle_ = root_dictionary + 1;
};

}  // namespace

void write_dxf(const std::filesystem::path& target, const FlatDrawing& drawing) {
  write_file_atomically(target, DxfWriter(drawing).run());
}

}  // namespace latticast
