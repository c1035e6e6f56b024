// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh preconditions: what every mesh must be before it is written.
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// Throws std::invalid_argument unless the mesh has triangles, fewer than 2^31 of them and of
/// vertices, and no index past its vertices.
void require_valid(const TriangleMesh& mesh);

/// Throws std::invalid_argument unless every coordinate is finite at float32.
void require_finite(std::span<const Point> points);

}  // namespace latticast
