// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic triangulation of one period of the unrolled plane, its opposite sides alike node for
// node: what a unit cell is swept from.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/pattern/plane_point.h"
#include "geometry/solid/period_outline.h"

namespace latticast {

struct PeriodMesh {
  struct Node {
    PlanePoint at;            ///< u from the box's left side, z from the plane's start
    std::uint32_t image = 0;  ///< the node that it repeats, or itself
  };
  struct Triangle {
    std::array<std::uint32_t, 6> nodes{};  ///< corners 0, 1, 2 counter-clockwise seen from outside,
                                           ///< then the middles of 01, 12, 20
    Layers layers = 0;                     ///< that are material there
  };

  PeriodBox box;
  std::vector<Node> nodes;
  std::vector<Triangle> triangles;  ///< of all the period, material or not
};

/// Angles of triangles are at least 20 degrees where the drawing allows it. Middles of sides along
/// a curve lie on it, and every triangle is material of a layer all over or nowhere. Throws
/// GeometryError where opposite sides cannot be made alike, or where sides along curves turn
/// triangles over however little they turn.
PeriodMesh triangulate_period(const Region& region, const Period& period,
                              const PeriodDivision& division);

}  // namespace latticast
