// SPDX-License-Identifier: GPL-3.0-or-later
// STL. Binary: an 80-byte header, a 32-bit count, and 50 bytes a triangle, all little-endian. Text:
// "solid", "facet", "vertex" and their ends, a line each.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The mesh as binary STL. Precondition: its indices are valid and it has fewer than 2^32
/// triangles.
std::string encode_stl(const TriangleMesh& mesh);

/// Whether the bytes are text STL rather than binary: they begin with "solid" and do not have the
/// length that a binary file with their count would have (some programs begin binary files with
/// "solid", too).
bool is_text_stl(std::string_view bytes);

/// The mesh in binary STL, three vertices to a triangle; the stored normals are not used. Throws
/// FileError naming `file` unless the length is exactly what the triangle count asks for.
TriangleMesh decode_binary_stl(const std::filesystem::path& file, std::string_view bytes);

/// The mesh in text STL, all its solids, as above. Throws FileError naming `file` and the line of a
/// statement that is unknown or out of place, and for a last solid without its end.
TriangleMesh decode_text_stl(const std::filesystem::path& file, std::string_view text);

}  // namespace latticast
