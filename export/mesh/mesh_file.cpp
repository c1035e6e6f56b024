// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include "design/file_error.h"
#include "export/atomic_file.h"
#include "export/mesh/glb_file.h"
#include "export/mesh/mesh_checks.h"
#include "export/mesh/obj_file.h"
#include "export/mesh/ply_file.h"
#include "export/mesh/stl_file.h"
#include "export/mesh/three_mf_file.h"

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

std::string lower_case_extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

TriangleMesh decode(const std::filesystem::path& file, std::string_view bytes) {
  const std::string extension = lower_case_extension(file);
  if (extension == ".stl") {
    return is_text_stl(bytes) ? decode_text_stl(file, bytes) : decode_binary_stl(file, bytes);
  }
  if (extension == ".obj") {
    return decode_obj(file, bytes);
  }
  if (extension == ".ply") {
    return decode_ply(file, bytes);
  }
  if (extension == ".glb") {
    return decode_glb(file, bytes);
  }
  if (extension == ".3mf") {
    return decode_three_mf(file, bytes);
  }
  throw FileError(
      file, "is not known as a mesh file: it needs the extension .stl, .obj, .ply, .3mf or .glb");
}

std::string encode(const TriangleMesh& mesh, MeshFormat format, const std::string& name) {
  switch (format) {
    case MeshFormat::stl:
      return encode_stl(mesh);
    case MeshFormat::obj:
      return encode_obj(mesh);
    case MeshFormat::ply:
      return encode_ply(mesh);
    case MeshFormat::three_mf:
      return encode_three_mf(std::array{NamedMesh{name, mesh}});
    case MeshFormat::glb:
      return encode_glb({{{name, mesh}}});
  }
  throw std::invalid_argument("no mesh format");
}

}  // namespace

std::string_view extension(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return ".stl";
    case MeshFormat::obj:
      return ".obj";
    case MeshFormat::three_mf:
      return ".3mf";
    case MeshFormat::ply:
      return ".ply";
    case MeshFormat::glb:
      return ".glb";
  }
  throw std::invalid_argument("no mesh format");
}

void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, MeshFormat format) {
  require_valid(mesh);
  write_file_atomically(file, encode(mesh, format, file.stem().string()));
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  return read_mesh_bytes(file, read_bytes(file));
}

TriangleMesh read_mesh_bytes(const std::filesystem::path& file, std::string_view bytes) {
  if (bytes.empty()) {
    throw FileError(file, "is empty");
  }
  TriangleMesh mesh = decode(file, bytes);
  if (mesh.triangles.empty()) {
    throw FileError(file, "holds no triangle");
  }
  return mesh;
}

}  // namespace latticast
