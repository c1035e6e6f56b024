// SPDX-License-Identifier: GPL-3.0-or-later
// PNG writer (libpng): a picture becomes a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace latticast {

/// Rows from the top, pixels from the left, four bytes each: red, green, blue (sRGB), opacity (not
/// premultiplied).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The image as PNG of 8 bits a channel, without dates or other text: the same image gives the same
/// bytes. Fully opaque images are written without the opacity channel. Throws std::runtime_error,
/// and std::invalid_argument for an empty image or one whose data has another size.
std::string encode_png(const Image& image);

/// Writes encode_png(image). The file appears whole or not at all (TemporaryFile). Throws
/// FileError, and as that does.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace latticast
