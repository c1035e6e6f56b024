// SPDX-License-Identifier: GPL-3.0-or-later
// OFF, Geomview's Object File Format: the word "OFF", the counts of vertices, faces and edges, then
// a line for each vertex and each face, as text [Geomview].
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The mesh as OFF text, vertices shared as `mesh` does; each coordinate has nine significant
/// digits, which identify a float32. The count of edges, which readers pass over, is 0.
/// Precondition: its indices are valid.
std::string encode_off(const TriangleMesh& mesh);

/// The vertices and faces of OFF text, vertices shared as the file shares them. Faces of more than
/// three corners become triangles in their plane (polygon_triangles.h); colours after a vertex or a
/// face, empty lines and comments from "#" are passed over. The word may be COFF (vertices with
/// colours) or missing, as Geomview has it. A byte-order mark of UTF-8 is passed over. Throws
/// FileError naming `file` and the line for another word (normals, texture, four or n dimensions,
/// binary), for what cannot be read, and for a vertex or face that is missing or left over.
TriangleMesh decode_off(const std::filesystem::path& file, std::string_view text);

}  // namespace latticast
