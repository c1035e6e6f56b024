// SPDX-License-Identifier: GPL-3.0-or-later
// How large a build's meshes will be, before any is made.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/plan.h"

namespace latticast {

struct PreparedDesign;

struct PlannedMesh {
  std::string name;        ///< of its files
  std::size_t copies = 1;  ///< as many meshes as pressures, in a preview
  double triangles = 0;    ///< about, of each
  double fitting_mm = 0;   ///< of one that is too large: an export.tolerance at which it is not
};

struct MeshPlan {
  std::vector<PlannedMesh> meshes;
  double triangles = 0;         ///< of all together
  double memory_bytes = 0;      ///< about, while building
  std::string unknown_preview;  ///< why a preview's size is not known; empty where it is
};

/// Estimates (geometry/solid/mesh_size.h) for all products that consist of meshes; predicts the
/// shapes that a preview will show. Molds are estimated from the lattices that they are made
/// around. Throws CannotDraw.
MeshPlan plan_meshes(PreparedDesign& prepared, const Plan& plan);

/// Throws UnsupportedDesign, with the number and a tolerance that fits, where a mesh or all of them
/// together would be too large.
void require_possible(const MeshPlan& meshes, double tolerance_mm);

/// For people, a line a mesh and one for all.
std::string describe(const MeshPlan& meshes);

}  // namespace latticast
