// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/flat/flat_drawing.h"

#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "design/file_error.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

// Two pieces, one with a hole; numbers that need all of their digits.
FlatDrawing example_drawing() {
  FlatDrawing drawing;
  drawing.title = "a <b> & c\xC3\xBC";
  drawing.width_mm = 106.81415022205297;
  drawing.height_mm = 85;
  drawing.notes = {"unrolled at mid radius 17 mm"};
  drawing.pieces = {{{{{0, 0}, {50, 0}, {50, 85}, {0, 85}},
                      {{10, 1.0 / 3}, {10, 20}, {40.123456789012345, 20}, {40, 1e-7}}}},
                    {{{{60, 0}, {106.81415022205297, 0}, {80, 84.999999999999}}}}};
  return drawing;
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::string plain = text;
  for (char& c : plain) {
    if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
  }
  std::istringstream words(plain);
  for (double number; words >> number;) numbers.push_back(number);
  return numbers;
}

std::vector<std::string> found(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) {
    all.push_back((*at)[1]);
  }
  return all;
}

// Tags of a DXF file with their values, as text.
std::vector<std::pair<int, std::string>> tags_of(const std::string& text) {
  std::vector<std::pair<int, std::string>> tags;
  std::istringstream lines(text);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    tags.emplace_back(std::stoi(code), value);
  }
  return tags;
}

TEST(FlatSvg, IsAtTrueScaleAndHoldsEveryPoint) {
  const TestFolder folder;
  const FlatDrawing drawing = example_drawing();
  write_svg(folder / "a.svg", drawing);
  const std::string text = bytes_of(folder / "a.svg");
  // Units of the picture are those of the paper.
  const std::string width = found(text, "<svg[^>]* width=\"([0-9.]+)mm\"").at(0);
  const std::string height = found(text, "<svg[^>]* height=\"([0-9.]+)mm\"").at(0);
  const std::vector<double> box = numbers_in(found(text, "viewBox=\"([^\"]*)\"").at(0));
  ASSERT_EQ(box.size(), 4U);
  EXPECT_EQ(box[2], std::stod(width));
  EXPECT_EQ(box[3], std::stod(height));
  EXPECT_LT(box[0], 0);
  EXPECT_GT(box[0] + box[2], drawing.width_mm);
  EXPECT_LT(box[1], 0);
  EXPECT_GT(box[1] + box[3], 85);
  // Nothing but paths and texts: some programs pass over rectangles and lines.
  EXPECT_EQ(text.find("<rect"), std::string::npos);
  EXPECT_EQ(text.find("<line"), std::string::npos);
  EXPECT_GE(found(text, "<path d=\"([^\"]*)\"").size(), 1U + 7 + 2);
  const std::vector<std::string> paths =
      found(text.substr(text.find("id=\"lattice\"")), "<path d=\"([^\"]*)\"");
  ASSERT_EQ(paths.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> expected;
    for (const DrawnOutline& outline : drawing.pieces[i].outlines) {
      for (const auto& [x, y] : outline) {
        expected.push_back(x);
        expected.push_back(85 - y);
      }
    }
    EXPECT_EQ(numbers_in(paths[i]), expected);
  }
  EXPECT_EQ(std::count(paths[0].begin(), paths[0].end(), 'Z'), 2);
}

TEST(FlatSvg, HasTheThreeGroupsAndEscapesTheTitle) {
  const TestFolder folder;
  write_svg(folder / "a.svg", example_drawing());
  const std::string text = bytes_of(folder / "a.svg");
  EXPECT_EQ(found(text, "<g id=\"([a-z]+)\""),
            (std::vector<std::string>{"sheet", "marks", "lattice"}));
  EXPECT_NE(text.find("a &lt;b&gt; &amp; c\xC3\xBC"), std::string::npos);
  EXPECT_EQ(text.find("<b>"), std::string::npos);
  for (const char* label : {">Theta = 0<", ">90<", ">180<", ">270<", ">50 mm<"}) {
    EXPECT_NE(text.find(label), std::string::npos) << label;
  }
}

TEST(FlatDxf, TellsMillimetresAndHoldsEveryPointOnItsLayer) {
  const TestFolder folder;
  const FlatDrawing drawing = example_drawing();
  write_dxf(folder / "a.dxf", drawing);
  const auto tags = tags_of(bytes_of(folder / "a.dxf"));
  std::map<std::string, std::string> header;
  std::vector<double> points;
  std::map<std::string, int> outlines;
  std::array<double, 2> shift{HUGE_VAL, HUGE_VAL};  // of the sheet's lower left corner
  int closed = 0;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (tags[i].first == 9) header[tags[i].second] = tags[i + 1].second;
    if (tags[i].first != 0 || tags[i].second != "LWPOLYLINE") continue;
    std::string layer;
    for (++i; tags[i].first != 0; ++i) {
      if (tags[i].first == 8) layer = tags[i].second;
      if (tags[i].first == 70) closed += tags[i].second == "1";
      if (layer == "SHEET" && (tags[i].first == 10 || tags[i].first == 20)) {
        double& least = shift[tags[i].first / 10 - 1];
        least = std::min(least, std::stod(tags[i].second));
      }
      if (layer != "LATTICE") continue;
      if (tags[i].first == 10 || tags[i].first == 20) points.push_back(std::stod(tags[i].second));
    }
    --i;
    ++outlines[layer];
  }
  EXPECT_EQ(header["$ACADVER"], "AC1015");
  EXPECT_EQ(header["$INSUNITS"], "4");
  EXPECT_EQ(outlines, (std::map<std::string, int>{{"LATTICE", 3}, {"SHEET", 1}}));
  EXPECT_EQ(closed, 4);
  std::vector<double> expected;
  for (const DrawnPiece& piece : drawing.pieces) {
    for (const DrawnOutline& outline : piece.outlines) {
      for (const auto& [x, y] : outline) {
        expected.push_back(x + shift[0]);
        expected.push_back(y + shift[1]);
      }
    }
  }
  EXPECT_EQ(points, expected);
  EXPECT_EQ(tags.back(), (std::pair<int, std::string>{0, "EOF"}));
}

TEST(FlatDxf, HasNoNegativeCoordinate) {
  const TestFolder folder;
  write_dxf(folder / "a.dxf", example_drawing());
  int coordinates = 0;
  for (const auto& [code, value] : tags_of(bytes_of(folder / "a.dxf"))) {
    const bool is_coordinate = (code >= 10 && code <= 12) || (code >= 20 && code <= 22);
    coordinates += is_coordinate ? 1 : 0;
    EXPECT_TRUE(!is_coordinate || std::stod(value) >= 0) << code;
  }
  EXPECT_GT(coordinates, 60);
}

TEST(FlatDxf, HasHandlesThatAreNeverUsedTwiceAndLettersOfAscii) {
  const TestFolder folder;
  FlatDrawing drawing = example_drawing();
  drawing.title = "\xCE\x98 \xE2\x82\xAC \xF0\x9F\x98\x80.";
  write_dxf(folder / "a.dxf", drawing);
  const std::string text = bytes_of(folder / "a.dxf");
  EXPECT_NE(text.find("\n\\U+0398 \\U+20AC ?.\n"), std::string::npos);
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c > 0; }));
  std::map<int, int> handles;
  int seed = 0;
  const auto tags = tags_of(text);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (tags[i].first != 5) continue;
    const int handle = std::stoi(tags[i].second, nullptr, 16);
    if (tags[i - 1].second == "$HANDSEED") {
      seed = handle;
    } else {
      EXPECT_EQ(++handles[handle], 1) << handle;
    }
  }
  EXPECT_GT(handles.size(), 20U);
  EXPECT_GT(seed, handles.rbegin()->first);
}

TEST(FlatDrawing, IsTheSameEveryTimeAndHasNoExponents) {
  const TestFolder folder;
  for (const char* name : {"a", "b"}) {
    write_svg(folder / (std::string(name) + ".svg"), example_drawing());
    write_dxf(folder / (std::string(name) + ".dxf"), example_drawing());
  }
  EXPECT_EQ(bytes_of(folder / "a.svg"), bytes_of(folder / "b.svg"));
  EXPECT_EQ(bytes_of(folder / "a.dxf"), bytes_of(folder / "b.dxf"));
  EXPECT_EQ(found(bytes_of(folder / "a.dxf"), "\n([0-9]+\\.0000001)\n").size(), 1U);
}

TEST(FlatDrawing, OfAShortSheetHasAShorterScaleBar) {
  const TestFolder folder;
  FlatDrawing drawing = example_drawing();
  drawing.height_mm = 12.5;
  write_svg(folder / "a.svg", drawing);
  EXPECT_NE(bytes_of(folder / "a.svg").find(">12.5 mm<"), std::string::npos);
}

TEST(FlatDrawing, NotesNameRadiusAnglesAndWidths) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, Rings{8, std::nullopt, 2.5}, {}};
  segment.lattice->grids = {{36, {2, 3, 2.5}, StraightPath{}},
                            {90, {1}, Horseshoe{2.656, 170, true}}};
  segment.lattice->fillet_mm = 0.5;
  std::string all;
  for (const std::string& line : drawing_notes(segment)) all += line + "\n";
  for (const char* part :
       {"radius 17 mm", "106.814 mm around", "rings: 2.5 mm",
        "grid 1: 3 strands at 36 degrees from the circumference, 2 to 3 mm wide",
        "grid 2: one strand at 90", "arcs of 170 degrees, radius 2.656 mm", "fillets: 0.5 mm"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  }
}

TEST(FlatDrawing, ThatCannotBeWrittenLeavesNothing) {
  const TestFolder folder;
  EXPECT_THROW(write_svg(folder / "missing" / "a.svg", example_drawing()), FileError);
  EXPECT_THROW(write_dxf(folder / "missing" / "a.dxf", example_drawing()), FileError);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace latticast
