// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files that assimp reads for us.
#pragma once

#include <filesystem>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The triangles of a file's bytes, read by assimp's readers for `extension` (".ply", ".3mf" or
/// ".glb") and no others. Meshes follow one another in the order of the nodes, moved as the nodes
/// say; polygons become fans from their first corner; points and lines are passed over. Throws
/// FileError naming `file` when assimp cannot read them or a face names a missing vertex.
TriangleMesh decode_with_assimp(const std::filesystem::path& file, std::string_view bytes,
                                std::string_view extension);

}  // namespace latticast
