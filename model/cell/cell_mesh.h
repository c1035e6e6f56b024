// SPDX-License-Identifier: GPL-3.0-or-later
// Finite-element mesh of a unit cell: one period of the tube with its lattice, whose images under
// constant rotations and shifts fill the tube. mm, rad, MPa.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "design/material/law.h"

namespace latticast {

/// What a node's component follows: an unknown with a sign, or none (it stays at rest).
struct NodeUnknown {
  std::int32_t number = -1;
  double sign = 1;
};

/// A node in cylinder coordinates at rest. Its displacement has three components, along the radial,
/// tangential and axial direction at its own rest angle, so that an image under a rotation about
/// the tube's axis has the same ones.
struct CellNode {
  double radius_mm = 0;
  double angle_rad = 0;
  double height_mm = 0;
  std::array<NodeUnknown, 3> unknown;
};

struct CellMaterial {
  Law law;  ///< of changes of shape
  double bulk_modulus_mpa = 0;
};

struct CellElement {
  std::array<std::int32_t, 27> nodes{};  ///< see hexahedron()
  std::int32_t material = 0;
};

struct CellMesh {
  std::vector<CellNode> nodes;
  std::vector<CellElement> elements;
  /// Faces of the bore, see quadrilateral(); their first axis runs around the tube with the angle,
  /// the second along it.
  std::vector<std::array<std::int32_t, 9>> bore;
  std::vector<CellMaterial> materials;
  int unknowns = 0;
  double inner_radius_mm = 0;
  double per_mm = 1;  ///< cells in a mm of the tube's length, all around
};

}  // namespace latticast
