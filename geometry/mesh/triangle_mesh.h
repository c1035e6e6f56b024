// SPDX-License-Identifier: GPL-3.0-or-later
// Indexed triangle mesh in mm, the one mesh type of the program.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace latticast {

using Point = std::array<double, 3>;            ///< x, y, z in mm; z along the tube
using Triangle = std::array<std::uint32_t, 3>;  ///< vertex indices, counter-clockwise from outside

/// Vertices may be shared by triangles or repeated; whoever needs one or the other says so.
struct TriangleMesh {
  std::vector<Point> vertices;
  std::vector<Triangle> triangles;
};

}  // namespace latticast
