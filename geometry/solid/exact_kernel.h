// SPDX-License-Identifier: GPL-3.0-or-later
// Exact predicates on double coordinates, by CGAL: for sources, not for headers.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline ExactKernel::Point_3 exact(const Point& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace latticast
