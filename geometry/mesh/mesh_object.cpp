// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_object.h"

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace latticast {
namespace {

void append(const TriangleMesh& mesh, TriangleMesh& whole) {
  if (mesh.vertices.size() > std::numeric_limits<std::uint32_t>::max() - whole.vertices.size()) {
    throw std::length_error("more vertices than a mesh can number");
  }
  const auto first = static_cast<std::uint32_t>(whole.vertices.size());
  whole.vertices.insert(whole.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const Triangle& t : mesh.triangles) {
    whole.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace

std::string title_of(const std::vector<MeshObject>& objects, std::size_t index) {
  constexpr std::size_t longest = 60;
  const std::string& name = objects.at(index).name;
  if (name.empty()) return "object " + std::to_string(index + 1);
  std::string title = "\"";
  for (const char c : name.substr(0, longest)) {
    title += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return title + (name.size() > longest ? "…\"" : "\"");
}

TriangleMesh joined(std::vector<MeshObject> objects) {
  std::vector<TriangleMesh> meshes;
  meshes.reserve(objects.size());
  for (MeshObject& object : objects) meshes.push_back(std::move(object.mesh));
  return joined(std::move(meshes));
}

TriangleMesh joined(std::vector<TriangleMesh> meshes) {
  if (meshes.size() == 1) return std::move(meshes.front());
  TriangleMesh whole;
  for (TriangleMesh& mesh : meshes) {
    append(mesh, whole);
    mesh = {};
  }
  return whole;
}

}  // namespace latticast
