// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh object: one of the meshes that a file keeps apart.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// A mesh where it stands. Objects share no vertices and are judged one by one: they may touch.
struct MeshObject {
  std::string name;  ///< as the file says it; may be empty, and may come twice
  TriangleMesh mesh;
};

/// How messages call object `index`: its name in quotes, cut short where it is long, without
/// control characters; or "object 3", counted from 1.
std::string title_of(const std::vector<MeshObject>& objects, std::size_t index);

/// All objects as one mesh, one after the other; nothing is joined, reordered or dropped. Throws
/// std::length_error for more vertices than a mesh can number.
TriangleMesh joined(std::vector<MeshObject> objects);
TriangleMesh joined(std::vector<TriangleMesh> meshes);

}  // namespace latticast
