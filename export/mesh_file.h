// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files, in mm. What is written can be read back bit for bit at float32.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"
#include "spec/design.h"

namespace latticast {

/// A mesh format that cannot be written. what() names it and those that can.
struct UnsupportedFormat : std::runtime_error {
  explicit UnsupportedFormat(MeshFormat unsupported);

  MeshFormat format;
};

/// The format's file extension with its dot, as in ".stl".
std::string_view extension(MeshFormat format);

/// Whether write_mesh can write the format: stl, obj and ply can be written so far.
bool can_write(MeshFormat format);

/// Writes a mesh, coordinates rounded to float32, triangles in order. The bytes depend on the mesh
/// alone: no dates, names or paths. The file appears whole or not at all (TemporaryFile).
/// Coordinates that are not finite are written as they are.
///
/// STL is binary, with unit facet normals (zero for a facet without area). OBJ shares vertices as
/// `mesh` does, gives each coordinate the fewest digits that identify the float32, and has neither
/// materials nor a second file. PLY is binary, little-endian, and shares vertices likewise.
///
/// Throws UnsupportedFormat, FileError, and std::invalid_argument for a mesh without triangles or
/// with an index past its vertices.
void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, MeshFormat format);

/// Reads a mesh of triangles from STL (binary or text), OBJ, PLY, 3MF or GLB, told apart by the
/// extension; larger polygons become triangles. Nothing is joined, reordered or dropped, collapsed
/// triangles and coordinates that are not finite included; several meshes in a file follow one
/// another, placed as the file's nodes say. STL gives every triangle three vertices of its own
/// (weld() shares them again). Coordinates are float32 values, for STL, OBJ and PLY exactly
/// those nearest to what the file says.
///
/// Throws FileError for a file that cannot be opened, is empty, contradicts itself or holds no
/// triangle, and for STL and PLY that is cut short or too long. For STL, OBJ and PLY memory is
/// asked for in proportion to the file's size, never to a count that it claims. The others are read
/// by assimp, whose readers are less careful with damaged files.
TriangleMesh read_mesh(const std::filesystem::path& file);

/// The same from the bytes of a file; `file` gives the extension and the name in errors, and is not
/// opened.
TriangleMesh read_mesh_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
