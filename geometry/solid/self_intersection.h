// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Are the triangle's corners equal or on one line? Exact.
bool is_degenerate(const TriangleMesh& mesh, const Triangle& triangle);

}  // namespace latticast
