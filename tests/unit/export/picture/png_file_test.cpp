// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/png_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include "design/file_error.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

Image coloured(bool opaque) {
  Image image{7, 5, {}};
  for (int i = 0; i < 35; ++i) {
    image.rgba.push_back(static_cast<std::uint8_t>(7 * i));
    image.rgba.push_back(static_cast<std::uint8_t>(255 - 5 * i));
    image.rgba.push_back(static_cast<std::uint8_t>(i * i));
    image.rgba.push_back(static_cast<std::uint8_t>(opaque ? 255 : 4 * i));
  }
  return image;
}

Image read_png(const std::filesystem::path& file, png_uint_32& format) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&header, file.c_str()), 0) << header.message;
  format = header.format;
  header.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(header));
  EXPECT_NE(png_image_finish_read(&header, nullptr, image.rgba.data(), 0, nullptr), 0);
  return image;
}

TEST(PngFile, HoldsThePixels) {
  const TestFolder folder;
  for (const bool opaque : {true, false}) {
    write_png(folder / "a.png", coloured(opaque));
    png_uint_32 format = 0;
    const Image read = read_png(folder / "a.png", format);
    EXPECT_EQ(read.width, 7);
    EXPECT_EQ(read.height, 5);
    EXPECT_EQ(read.rgba, coloured(opaque).rgba);
    EXPECT_EQ((format & PNG_FORMAT_FLAG_ALPHA) == 0, opaque);
  }
}

TEST(PngFile, SameImageSameBytesWithoutDates) {
  const TestFolder folder;
  write_png(folder / "a.png", coloured(true));
  write_png(folder / "b.png", coloured(true));
  const std::string bytes = bytes_of(folder / "a.png");
  EXPECT_EQ(bytes, bytes_of(folder / "b.png"));
  for (const std::string chunk : {"tIME", "tEXt", "zTXt", "iTXt"}) {
    EXPECT_EQ(bytes.find(chunk), std::string::npos) << chunk;
  }
}

TEST(PngFile, RefusesImagesThatAreNot) {
  const TestFolder folder;
  EXPECT_THROW(write_png(folder / "a.png", Image{}), std::invalid_argument);
  EXPECT_THROW(write_png(folder / "a.png", Image{2, 2, std::vector<std::uint8_t>(15)}),
               std::invalid_argument);
  EXPECT_THROW(write_png(folder / "none/a.png", coloured(true)), FileError);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace latticast
