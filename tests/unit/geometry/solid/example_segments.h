// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "design/design.h"

namespace latticast {

/// Liner 12 to 16, lattice 16 to 18, 85 long: eight rings and eight strips of 2.
inline Segment example_segment(double angle_deg = 36) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, Rings{8, std::nullopt, 2}, {}};
  segment.lattice->grids = {{angle_deg, std::vector<double>(8, 2.0), StraightPath{}}};
  return segment;
}

/// The example without rings: strips alone, whose walls can be told apart.
inline Segment strips_only(double angle_deg, double inner_radius_mm, double thickness_mm) {
  Segment segment;
  segment.length_mm = 30;
  segment.liner = {0.5 * inner_radius_mm, 0.5 * inner_radius_mm, {}};
  segment.lattice = Lattice{thickness_mm, {}, std::nullopt, {}};
  segment.lattice->grids = {{angle_deg, std::vector<double>(3, 2.0), StraightPath{}}};
  return segment;
}

/// Supplementary families that leave a window which ends a few grid steps before a third side: of
/// the triangles there, some Delaunay ones would be far lower than float32 can tell.
inline Segment narrow_windows() {
  Segment segment;
  segment.length_mm = 32.84091236;
  segment.liner = {9.479393477, 4.457578991, {}};
  segment.lattice = Lattice{3.729674569, {}, std::nullopt, {}};
  segment.lattice->grids = {{157.7142928, std::vector<double>(10, 3.765127723), StraightPath{}},
                            {22.28493312, std::vector<double>(11, 3.422730549), StraightPath{}}};
  return segment;
}

}  // namespace latticast
