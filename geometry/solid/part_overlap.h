// SPDX-License-Identifier: GPL-3.0-or-later
// Overlap of parts: where two objects of one file claim the same room. Contact is none.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh/mesh_object.h"

namespace latticast {

/// What two parts may stand in each other and still count as touching: curved contact surfaces are
/// meshed with chords, which reach into each other by the parts' tolerances.
inline constexpr double contact_depth_mm = 0.1;

struct PartOverlap {
  std::size_t first = 0;  ///< of the objects, first < second
  std::size_t second = 0;
  double depth_mm = 0;    ///< the thickest place: the shortest way through it along x, y or z
  double volume_mm3 = 0;  ///< that both claim, to a few percent
  Point where{};          ///< inside the thickest place
};

struct PartOverlaps {
  std::vector<PartOverlap> found;  ///< in the order of the objects
  bool searched_all = true;        ///< false where there were too many of them to look at
};

/// Pairs of objects that share more than a layer of contact_depth_mm. Each pair is sampled along
/// lines parallel to x, y and z, 100 by 100 over the box that both have in common: what is narrower
/// than a hundredth of that box may be missed. `sound[i]` says that object i is closed and faces
/// outwards; others are left out. Time: the objects, sorted, plus for each pair whose boxes overlap
/// the triangles of both. Ends after 100 pairs that overlap, and after some thousand that do not,
/// or 3 * 10^8 triangles.
PartOverlaps overlapping_parts(const std::vector<MeshObject>& objects,
                               const std::vector<bool>& sound);

}  // namespace latticast
