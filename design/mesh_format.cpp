// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/mesh_format.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace latticast {

std::string_view extension(MeshFormat format) {
  for (const MeshFormatName& known : mesh_format_names) {
    if (known.format == format) return known.suffix;
  }
  throw std::invalid_argument("no mesh format");
}

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const MeshFormatName& known : mesh_format_names) {
    if (known.suffix == suffix) return known.format;
  }
  return std::nullopt;
}

std::string mesh_suffixes() {
  std::string text;
  for (std::size_t i = 0; i < mesh_format_names.size(); ++i) {
    if (i > 0) text += i + 1 == mesh_format_names.size() ? " or " : ", ";
    text += mesh_format_names[i].suffix;
  }
  return text;
}

}  // namespace latticast
