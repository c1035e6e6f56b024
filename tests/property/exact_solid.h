// SPDX-License-Identifier: GPL-3.0-or-later
// The true solid of a segment's layer, round and smooth, and how far places are from its surface.
#pragma once

#include <functional>
#include <optional>

#include "geometry/mesh/triangle_mesh.h"
#include "tests/property/exact_lattice.h"

namespace latticast {

using Map = std::function<Point(const Point&)>;

class ExactSolid {
 public:
  static ExactSolid lattice(const Segment& segment, double start_z_mm);
  static ExactSolid liner(const Segment& segment, double start_z_mm);

  /// Distance of a place from the surface, to first order in it; places deeper than `reach_mm`
  /// below all faces count as that far.
  double distance_mm(const Point& place, double reach_mm) const;

  /// The same for the surface moved by a map, the place being close to where the map takes `rest`.
  double distance_mm(const Point& place, double reach_mm, const Map& map, const Point& rest) const;

  /// Exact; for lattices without fillets.
  double volume_mm3() const;

 private:
  ExactSolid(double floor, double ceiling, double length, double start);

  double floor_;
  double ceiling_;
  double length_;
  double start_;
  std::optional<ExactLattice> lattice_;
};

/// Largest distance of points spread over about `triangles` of a mesh's triangles from the surface.
/// With a map, `rest` is the mesh that was moved.
double largest_distance_mm(const TriangleMesh& mesh, const ExactSolid& exact, double reach_mm,
                           std::size_t triangles);
double largest_distance_mm(const TriangleMesh& mesh, const ExactSolid& exact, double reach_mm,
                           std::size_t triangles, const Map& map, const TriangleMesh& rest);

}  // namespace latticast
