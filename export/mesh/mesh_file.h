// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh file writer and reader: one mesh in mm, read back bit for bit at float32. mesh_formats.h
// lists the formats.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "design/mesh_format.h"
#include "export/mesh/mesh_look.h"
#include "geometry/mesh/mesh_object.h"

namespace latticast {

/// Writes a mesh, coordinates rounded to float32, triangles in order. The bytes depend on the mesh,
/// for 3MF and GLB on the file's name without extension, which names the part, and for these on the
/// program's version: no dates or paths. The file appears whole or not at all (TemporaryFile).
///
/// STL is binary, with unit facet normals (zero for a facet without area). OBJ shares vertices as
/// `mesh` does, gives each coordinate the fewest digits that identify the float32, and has neither
/// materials nor a second file. PLY is binary, little-endian, and shares vertices likewise; so do
/// 3MF and GLB, which hold one part (write_three_mf and write_glb write several). Numbers are mm in
/// all but GLB, whose root node turns them into its metres.
///
/// Text STL has the fewest digits that identify the float32. The part's colour is kept by 3MF and
/// GLB, colours and qualities of the vertices by PLY. Coordinates that are not finite are written
/// as they are where the format keeps them (MeshFileFormat). Throws FileError, and
/// std::invalid_argument for a mesh without triangles or with an index past its vertices, and for
/// 3MF and GLB what write_three_mf and write_glb say.
void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, MeshFormat format,
                const MeshLook& look = {});

/// Reads meshes of triangles in mm from a file of any format, told apart by the suffix; larger
/// polygons become triangles. Nothing is joined, reordered or dropped, collapsed triangles and
/// coordinates that are not finite included. 3MF and GLB hold one object or many, placed as the
/// file says; the other formats one. 3MF says its unit and GLB is in metres with y upward, which
/// becomes mm with z upward; the numbers of the others are taken as mm. STL gives every triangle
/// three vertices of its own (weld() shares them again). Coordinates are float32 values, exactly
/// those nearest to what the file says unless it moves or scales them.
///
/// Throws FileError for a file that cannot be opened, is empty, contradicts itself, holds no
/// triangle, or is cut short (for OBJ only where that shows). Memory grows with the file's size,
/// for 3MF with that of its unpacked model and for both 3MF and GLB with the number of times that
/// it uses a mesh, never with a count that it claims.
std::vector<MeshObject> read_objects(const std::filesystem::path& file);

/// The same from the bytes of a file; `file` gives the extension and the name in errors, and is not
/// opened.
std::vector<MeshObject> read_objects_bytes(const std::filesystem::path& file,
                                           std::string_view bytes);

/// All objects of a file as one mesh, one after the other.
TriangleMesh read_mesh(const std::filesystem::path& file);
TriangleMesh read_mesh_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
