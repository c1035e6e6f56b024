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
  const std::string& name = objects.at(index).name;
  return name.empty() ? "object " + std::to_string(index + 1) : '"' + name + '"';
}

TriangleMesh joined(std::vector<MeshObject> objects) {
  if (objects.size() == 1) return std::move(objects.front().mesh);
  TriangleMesh whole;
  for (MeshObject& object : objects) {
    append(object.mesh, whole);
    object.mesh = {};
  }
  return whole;
}

}  // namespace latticast
