// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cell of any lattice that repeats along the tube: drawn and united as its solid is, one
// period of the plane triangulated and swept through the wall (docs/unit-cell.md#any-lattice).
#pragma once

#include <optional>
#include <string>

#include "design/design.h"
#include "geometry/mesh/wedge_mesh.h"
#include "model/cell/unit_cell.h"

namespace latticast {

/// Meshes of a cell, each of half the element size of the one before.
inline constexpr int drawn_levels = 3;

/// Precondition: liner and lattice are materials that a cell knows, and the lattice has strands. In
/// builds without geometry there is none.
FoundCell find_drawn_cell(const Segment& segment, int level = 0);

/// A wedge mesh, or why there is none.
struct FoundWedges {
  std::optional<WedgeMesh> mesh;
  std::string reason;
};

/// The whole segment as it is drawn, end to end, or one of its equal sectors around the tube, for
/// finite-element programs (docs/decks.md): one element, at `size` 1, across the thinnest strand.
/// Preconditions as above; builds with geometry.
FoundWedges find_drawn_wedges(const Segment& segment, bool whole, double size = 1);

}  // namespace latticast
