// SPDX-License-Identifier: GPL-3.0-or-later
// STL. Binary: an 80-byte header, a 32-bit count, and 50 bytes a triangle, all little-endian. Text:
// "solid", "facet", "vertex" and their ends.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The mesh as binary STL. Precondition: its indices are valid and it has fewer than 2^32
/// triangles.
std::string encode_stl(const TriangleMesh& mesh);

/// The mesh as text STL, one solid of the part's name (blanks in it become "_"). Coordinates have
/// the fewest digits that identify the float32. Precondition: its indices are valid.
std::string encode_text_stl(const TriangleMesh& mesh, std::string_view name);

/// The mesh in binary or text STL, all its solids, three vertices to a triangle; the stored normals
/// are not used. Text begins with "solid" and does not have the length that a binary file with its
/// count would have: some programs begin binary files with "solid", too. Text may be in capitals,
/// on one line, with "end loop" for "endloop", with comments from "#", ";" or "//" to the end of
/// the line and with a byte-order mark of UTF-8. Throws FileError naming `file` unless a binary
/// file is exactly as long as its triangle count asks for; for text with the line of a statement
/// that is unknown or out of place, and for a last solid without its end.
TriangleMesh decode_stl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
