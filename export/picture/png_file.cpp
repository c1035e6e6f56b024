// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/png_file.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include <png.h>

#include "design/file_error.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) {
      return false;
    }
  }
  return true;
}

std::vector<std::uint8_t> without_opacity(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
  }
  return rgb;
}

}  // namespace

std::string encode_png(const Image& image) {
  if (image.width <= 0 || image.height <= 0 ||
      image.rgba.size() != std::size_t{4} * image.width * image.height) {
    throw std::invalid_argument("an image whose data does not have the size it says");
  }
  const bool opaque = is_opaque(image);
  const std::vector<std::uint8_t> pixels = opaque ? without_opacity(image.rgba) : image.rgba;
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("a picture cannot be encoded: ") +
                             static_cast<const char*>(header.message));
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& file, const Image& image) {
  write_file_atomically(file, encode_png(image));
}

}  // namespace latticast
