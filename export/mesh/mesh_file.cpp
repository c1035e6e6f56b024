// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/mesh_file.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "design/file_error.h"
#include "export/mesh/mesh_checks.h"
#include "export/mesh/mesh_formats.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw FileError(file, "does not exist");
  }
  if (std::filesystem::is_directory(status)) {
    throw FileError(file, "is a folder");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw FileError(file, "is not a regular file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw FileError(file, "cannot be opened");
  }
  std::string bytes(std::filesystem::file_size(file, error), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (error || !stream) {
    throw FileError(file, "cannot be read");
  }
  return bytes;
}

}  // namespace

void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, MeshFormat format,
                const MeshLook& look) {
  require_valid(mesh);
  for (const std::size_t count : {look.vertex_colours.size(), look.vertex_qualities.size()}) {
    if (count != 0 && count != mesh.vertices.size()) {
      throw std::invalid_argument("not one colour or quality for each vertex of a mesh");
    }
  }
  const std::string name = file.stem().string();
  write_file_atomically(file, mesh_file_format(format).encode({mesh, name, look}));
}

std::vector<MeshObject> read_objects(const std::filesystem::path& file) {
  return read_objects_bytes(file, read_bytes(file));
}

std::vector<MeshObject> read_objects_bytes(const std::filesystem::path& file,
                                           std::string_view bytes) {
  if (bytes.empty()) {
    throw FileError(file, "is empty");
  }
  const std::optional<MeshFormat> format = mesh_format_of(file);
  if (!format) {
    throw FileError(file, "is not known as a mesh file: it needs the extension " + mesh_suffixes());
  }
  std::vector<MeshObject> objects = mesh_file_format(*format).decode(file, bytes);
  if (std::all_of(objects.begin(), objects.end(),
                  [](const MeshObject& object) { return object.mesh.triangles.empty(); })) {
    throw FileError(file, "holds no triangle");
  }
  return objects;
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  return joined(read_objects(file));
}

TriangleMesh read_mesh_bytes(const std::filesystem::path& file, std::string_view bytes) {
  return joined(read_objects_bytes(file, bytes));
}

}  // namespace latticast
