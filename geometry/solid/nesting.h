// SPDX-License-Identifier: GPL-3.0-or-later
// Nesting of closed bodies: the winding number of each one's surroundings, by exact ray casting.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// For each body of a mesh, the winding number of all others around it: 0 outside, 1 inside a
/// solid, 0 again inside a cavity of a solid. `bodies[i]` lists the triangles of body i.
/// Precondition: every body is closed and consistently oriented, and no two triangles intersect.
/// Exact. Time: bodies squared, plus, for a body inside another's bounding box, that other's size.
std::vector<int> surrounding_winding(const TriangleMesh& mesh,
                                     const std::vector<std::vector<std::uint32_t>>& bodies);

}  // namespace latticast
