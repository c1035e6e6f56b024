// SPDX-License-Identifier: GPL-3.0-or-later
// Finite-element mesh of a unit cell: one period of the tube with its lattice, whose images under
// constant rotations and shifts fill the tube. mm, rad, MPa.
#pragma once

#include <array>
#include <cstddef>
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

template <std::size_t N>
struct CellElement {
  std::array<std::int32_t, N> nodes{};
  std::int32_t material = 0;
};
using CellHexahedron = CellElement<27>;  ///< see hexahedron()
using CellWedge = CellElement<21>;       ///< see wedge()

/// Part of the bore's surface.
template <std::size_t N>
using BoreFace = std::array<std::int32_t, N>;
using BoreQuadrilateral = BoreFace<9>;  ///< first axis around the tube with the angle, second along
using BoreTriangle = BoreFace<7>;       ///< counter-clockwise seen from outside the tube

struct WeightedNode {
  std::int32_t node = 0;
  double weight = 0;  ///< in a mean
};

struct CellMesh {
  std::vector<CellNode> nodes;
  std::vector<CellHexahedron> hexahedra;
  std::vector<CellWedge> wedges;
  std::vector<BoreQuadrilateral> bore_quadrilaterals;
  std::vector<BoreTriangle> bore_triangles;
  std::vector<CellMaterial> materials;
  /// Nodes all around the bore whose mean displacement across the tube, and mean turn about it, are
  /// kept at zero: that is where the tube's axis is, when no symmetry says so.
  std::vector<WeightedNode> centred;
  int unknowns = 0;
  double inner_radius_mm = 0;
  double per_mm = 1;  ///< cells in a mm of the tube's length, all around
};

}  // namespace latticast
