// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file: what its elements are made of.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace latticast {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_in_bytes(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> list_length;  ///< of a list: the type of the length before its values
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes to where the values begin
};

/// Reads the lines from "ply" to "end_header", which end with "\n", "\r\n" or
/// "\r", as the first does. Throws FileError
/// naming `file`, and the line where there is one, for a header without an end or a format, a line
/// of another kind or out of place, an unknown type, a list length that is no integer, a name that
/// comes twice, and an element with more instances than the file has bytes.
PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
