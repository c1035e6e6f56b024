// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: vertices ("v") and faces ("f") as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The mesh as OBJ text, an object with the part's name (blanks in it become "_"). Precondition:
/// its indices are valid.
std::string encode_obj(const TriangleMesh& mesh, std::string_view name = {});

/// The vertices and faces of OBJ text, vertices shared as the file shares them. Faces of more than
/// three corners become triangles in their plane (polygon_triangles.h); texture, normals, colours,
/// groups, materials, points and lines are passed over. A byte-order mark of UTF-8 is passed over.
/// Throws FileError naming `file` and the line of a vertex or face that cannot be read.
TriangleMesh decode_obj(const std::filesystem::path& file, std::string_view text);

}  // namespace latticast
