// SPDX-License-Identifier: GPL-3.0-or-later
// Table of mesh file formats: the writer and the reader of each, and what it keeps of a mesh.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/mesh_format.h"
#include "export/mesh/mesh_look.h"
#include "geometry/mesh/mesh_object.h"

namespace latticast {

/// A mesh on its way into a file. It refers to what it was made from.
struct MeshToWrite {
  const TriangleMesh& mesh;  ///< in mm, its indices valid
  std::string_view name;     ///< of the part
  MeshLook look;
};

struct MeshFileFormat {
  MeshFormat format;
  std::string (*encode)(const MeshToWrite& part);  ///< leaves out what the format does not keep
  std::vector<MeshObject> (*decode)(const std::filesystem::path& file, std::string_view bytes);
  bool keeps_vertex_numbers;  ///< otherwise every triangle has three vertices of its own
  bool keeps_infinite;        ///< infinite coordinates and those that are no number; else refused
  bool keeps_part_name;
};

/// The row of a format.
const MeshFileFormat& mesh_file_format(MeshFormat format);

}  // namespace latticast
