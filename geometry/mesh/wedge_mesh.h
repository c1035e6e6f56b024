// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh of 15-node wedges: quadratic triangles swept through the wall, for finite-element programs.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace latticast {

enum class WedgePart : std::uint8_t { liner, lattice };

/// Nodes: three corners of the inner triangle, counter-clockwise seen from outside the tube; the
/// same of the outer one; middles of the inner edges 1-2, 2-3, 3-1; of the outer ones; of the edges
/// 1-4, 2-5, 3-6.
struct Wedge {
  std::array<std::int32_t, 15> nodes{};
  WedgePart part = WedgePart::liner;
};

/// A tube with its lattice, or one of its equal sectors. mm; the axis is z, the base at z = 0.
struct WedgeMesh {
  std::vector<std::array<double, 3>> nodes;
  std::vector<Wedge> wedges;
  std::vector<std::int32_t> bore;  ///< wedges whose inner triangle is a part of the bore
  std::vector<std::int32_t> base;  ///< nodes
  std::vector<std::int32_t> tip;
  std::vector<std::int32_t> bond;  ///< nodes between liner and lattice
  /// Nodes on the sector's near side, each with its image on the far side, one sector further
  /// around; empty for a whole tube.
  std::vector<std::pair<std::int32_t, std::int32_t>> ties;
  int sectors = 1;  ///< that make the tube
  double length_mm = 0;
  double inner_radius_mm = 0;
};

}  // namespace latticast
