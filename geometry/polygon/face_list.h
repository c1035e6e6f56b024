// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of any number of corners on their way to become triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

class FaceList {
 public:
  /// Adds a face by its vertices' numbers. Precondition: three corners or more.
  void add(std::span<const std::uint32_t> corners);

  /// The triangles of all faces in their order (polygon_triangles.h). Precondition: no corner past
  /// `vertices`.
  std::vector<Triangle> triangles(std::span<const Point> vertices) &&;

 private:
  struct Polygon {
    std::size_t place = 0;  ///< how many triangles stand before it
    std::size_t first = 0;  ///< of its corners
  };

  std::vector<Triangle> triangles_;
  std::vector<Polygon> polygons_;
  std::vector<std::uint32_t> corners_;  ///< of the polygons
};

}  // namespace latticast
