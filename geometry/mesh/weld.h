// SPDX-License-Identifier: GPL-3.0-or-later
// Welding: one vertex for every distinct position.
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// Rounds coordinates to float32 (as mesh files hold them) and makes vertices with equal
/// coordinates one: -0.0 equals 0.0, and is given as 0.0; a vertex with a NaN coordinate equals no
/// other. Vertices come in the order of their first appearance, unused ones included; triangles
/// keep their order and orientation, and those that collapse onto a line or a point stay, for an
/// audit to find. Linear in time and memory. Precondition: fewer than 2^32 - 1 vertices.
TriangleMesh weld(const TriangleMesh& mesh);

/// Whether a surface has no rim: along every edge as many triangles run one way as the other. A
/// mesh without triangles has none.
bool is_closed(const TriangleMesh& welded);

/// Whether two meshes have the same triangles in the same order, corner by corner. What an audit
/// finds in one of two such meshes that are welded, it finds in the other. A NaN equals nothing.
bool same_triangles(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace latticast
