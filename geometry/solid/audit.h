// SPDX-License-Identifier: GPL-3.0-or-later
// Audit of a triangle mesh: closed, oriented, without degenerate or intersecting triangles, and its
// parts and genus, proved on the mesh itself.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

enum class Defect {
  not_finite,         ///< a vertex with a coordinate that is not a finite number
  degenerate,         ///< a triangle without area: two equal corners, or three on a line
  open_edge,          ///< an edge with one triangle only
  crowded_edge,       ///< an edge with more than two triangles
  inconsistent_edge,  ///< two triangles that run along their edge in the same direction
  pinched_vertex,     ///< two or more fans of triangles that meet in one vertex only
  self_intersection,  ///< two triangles that meet elsewhere than in a shared edge or vertex
  inside_out,  ///< a closed body facing inwards that is no cavity, or outwards inside another
};

std::string_view name(Defect defect);

struct Finding {
  Defect defect;
  Point where{};             ///< mm: the vertex, or the middle of the edge or triangle
  std::size_t triangle = 0;  ///< one of the triangles involved, 0-based in file order
};

/// The result of an audit. The invariants at the end mean something only for a mesh that passes.
struct Audit {
  std::size_t triangles = 0;
  std::size_t vertices = 0;  ///< used by a triangle
  std::size_t edges = 0;
  std::vector<std::size_t> counts = std::vector<std::size_t>(8);  ///< by Defect
  std::vector<Finding> findings;  ///< the first few of each defect, in file order within a defect
  bool searched_intersections = false;  ///< not searched when a coordinate is not finite

  int components = 0;
  int genus = 0;  ///< summed over the components
  double volume_mm3 = 0;
  double area_mm2 = 0;
  Point lowest{};  ///< bounding box
  Point highest{};

  std::size_t count(Defect defect) const { return counts[static_cast<std::size_t>(defect)]; }
  bool passes() const { return findings.empty(); }
  /// It has this defect and no other.
  bool has_only(Defect defect) const;
};

/// Audits a welded mesh (weld.h): every edge has two triangles that run along it in opposite
/// directions, every vertex one fan; no degenerate triangle; no self-intersection (exact
/// predicates, CGAL, on the coordinates as they are); every body faces outwards, but for cavities
/// inside a body, which face inwards (where other defects leave that undefined, the whole mesh must
/// not have negative volume). Time n log n, about 150 bytes a triangle; nesting.h for many bodies.
Audit audit(const TriangleMesh& welded);

}  // namespace latticast
