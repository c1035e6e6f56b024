// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a polygon in space: a constrained Delaunay triangulation in its plane (CGAL).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// Triangles between the corners of a polygon, by their numbers; all face as it does. They lie
/// inside of it, corners in the middle of a straight side have triangles of their own, and two
/// corners in one place count as one: a side that is walked there and back, as a keyhole has it,
/// bounds nothing. Corners off the plane are seen along the coordinate axis nearest to its normal.
///
/// Convex polygons are halved until triangles are left: the two of a quadrangle part at its first
/// corner. What has no inside is treated the same way: without area, with a coordinate that is not
/// finite, with sides that cross. Then triangles overlap or collapse, for an audit to find. Time
/// n log n for usual shapes. Precondition: three corners or more.
std::vector<Triangle> polygon_triangles(std::span<const Point> corners);

}  // namespace latticast
