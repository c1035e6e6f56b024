// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/lettering.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "export/picture/picture.h"
#include "export/picture/stroke_font.h"

namespace latticast {
namespace {

Image blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 255)};
}

bool is_dark(const Image& image, int column, int row) {
  return image.rgba[4 * (static_cast<std::size_t>(row) * image.width + column)] < 128;
}

// The box of dark pixels: left, right, top, bottom.
std::array<int, 4> ink(const Image& image) {
  std::array<int, 4> box{image.width, -1, image.height, -1};
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (!is_dark(image, column, row)) continue;
      box = {std::min(box[0], column), std::max(box[1], column), std::min(box[2], row),
             std::max(box[3], row)};
    }
  }
  return box;
}

TEST(Lettering, StandsOnItsLineAndIsAsHighAndWideAsItSays) {
  Image image = blank(300, 100);
  draw_text(image, {"HEX 20 kPa", {150, 70}, 30});
  const auto [left, right, top, bottom] = ink(image);
  EXPECT_NEAR(top, 40, 3);
  EXPECT_NEAR(bottom, 70, 3);
  EXPECT_NEAR(right - left, width_px("HEX 20 kPa", 30), 5);
  EXPECT_NEAR(0.5 * (left + right), 150, 2);
}

TEST(Lettering, EveryLetterOfUnitsAndNamesHasAShapeOfItsOwn) {
  std::set<std::string_view> shapes;
  const std::string letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.,/()%+:";
  for (const char letter : letters) {
    const std::string_view strokes = strokes_of(letter);
    EXPECT_NE(strokes, strokes_of_box) << letter;
    shapes.insert(strokes);
    for (const char c : strokes) EXPECT_TRUE(c == ' ' || (c >= '0' && c <= '8')) << letter;
  }
  EXPECT_EQ(shapes.size(), letters.size() - 1) << "only O and 0 look alike";
  EXPECT_EQ(strokes_of('~'), strokes_of_box);
}

TEST(Lettering, TakesAnyTextAndAnyPlace) {
  Image image = blank(40, 20);
  draw_text(image, {"\xC3\x97 \xE2\x82\xAC \xFF\x80", {0, 0}, 12});
  draw_text(image, {"far away", {1e9, -1e9}, 12});
  draw_text(image, {"", {20, 10}, 12});
  EXPECT_EQ(width_px("\xC3\x97", 6), width_px("x", 6));
  EXPECT_EQ(image.rgba.size(), 3200U);
}

TEST(Lettering, ItsRimKeepsItLegible) {
  Image image = blank(60, 60);
  std::fill(image.rgba.begin(), image.rgba.end(), 0);
  draw_text(image, {"I", {30, 45}, 30});
  const auto at = [&](int column, int row) { return image.rgba[4 * (row * 60 + column)]; };
  EXPECT_LT(at(30, 30), 60);
  EXPECT_GT(at(34, 30), 200);
}

// A cube of 10 mm, 400 pixels high between margins of a tenth: the bar is 10 mm or as long as
// a fifth of the picture allows, and as many pixels as the cube's edge has for them.
TEST(Picture, HasAScaleBarOfItsScale) {
  TriangleMesh square{{{0, -5, 0}, {0, 5, 0}, {0, 5, 10}, {0, -5, 10}}, {{0, 1, 2}, {0, 2, 3}}};
  PictureOptions options{.width = 600, .height = 500, .margin = 0.1, .transparent = false};
  PictureText text;
  text.scale_bar = true;
  const Image image = draw_picture({{square, {0.6, 0.6, 0.6}}}, {}, options, text);
  // 40 pixels a mm; a fifth of 600 pixels is 3 mm.
  int longest = 0;
  for (int row = 460; row < 500; ++row) {
    int run = 0;
    for (int column = 0; column < 300; ++column) {
      run = is_dark(image, column, row) ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(longest, 2 * 40, 4);
}

}  // namespace
}  // namespace latticast
