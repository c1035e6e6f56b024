// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: a text header that names elements and their properties, then their values in that order.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "export/mesh/mesh_look.h"
#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// The mesh as little-endian binary PLY: "vertex" with float x, y, z and, where the vertices have
/// colours, uchar red, green, blue (0 to 255, rounded; beyond that range cut off, NaN is 0), and
/// float quality, which MeshLab, CloudCompare and ParaView show as a field, where the vertices have
/// one; "face" with "list uchar int vertex_indices". Preconditions: valid indices below 2^31; no
/// colours and qualities, or one for each vertex. Programs shade the triangles between the colours
/// of their corners.
std::string encode_ply(const TriangleMesh& mesh, const MeshLook& look = {});

/// The vertices (x, y, z of "vertex"), faces (the list vertex_indices or vertex_index of "face")
/// and triangle strips (the same list of "tristrips", where -1 begins a new strip) of PLY, text or
/// binary in either byte order, vertices shared as the file shares them. Faces of more than three
/// corners become triangles in their plane (polygon_triangles.h); strips turn over with every
/// triangle, and those that only join strips, naming a vertex twice, are dropped; other properties
/// and elements are checked and passed over. Memory grows with the bytes, never with a count that
/// they claim.
///
/// Throws FileError naming `file` when the header has an unknown or misplaced line, when a value
/// does not have its property's type, a list is shorter than nothing, a face has fewer than three
/// corners or names a missing vertex, and when bytes are missing or left over.
TriangleMesh decode_ply(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
