// SPDX-License-Identifier: GPL-3.0-or-later
// Self-intersections of a triangle mesh: an exact test of all pairs whose boxes meet in a bounding
// volume hierarchy.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// All pairs of triangles that meet elsewhere than in the vertices or the edge that they share;
/// exact. Pairs are ordered. `skip[i]` leaves triangle i out (degenerate triangles must be).
/// Precondition: a welded mesh with finite coordinates.
std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(
    const TriangleMesh& mesh, const std::vector<char>& skip);

/// Does the mesh meet itself once its coordinates are rounded to float32 and welded, as in a file?
/// Degenerate triangles are left out.
bool intersects_itself(const TriangleMesh& mesh);

/// Are the triangle's corners equal or on one line? Exact.
bool is_degenerate(const TriangleMesh& mesh, const Triangle& triangle);

}  // namespace latticast
