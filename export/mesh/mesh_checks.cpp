// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace latticast {

void require_valid(const TriangleMesh& mesh) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("a mesh without triangles");
  }
  if (mesh.triangles.size() > most || mesh.vertices.size() > most) {
    throw std::invalid_argument("a mesh of more triangles or vertices than a mesh file can hold");
  }
  for (const Triangle& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) >= mesh.vertices.size()) {
      throw std::invalid_argument("a mesh whose triangle names a vertex that it does not have");
    }
  }
}

void require_finite(std::span<const Point> points) {
  for (const Point& point : points) {
    for (const double coordinate : point) {
      if (!std::isfinite(static_cast<float>(coordinate))) {
        throw std::invalid_argument("a mesh with a coordinate that is not finite");
      }
    }
  }
}

}  // namespace latticast
