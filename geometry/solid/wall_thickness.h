// SPDX-License-Identifier: GPL-3.0-or-later
// Wall thickness of a body along inward normals, by ray casting: where it is thinner than a printer
// can make it.
#pragma once

#include <limits>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// What was found thinner than the limit.
struct ThinWalls {
  double least_mm = std::numeric_limits<double>::infinity();  ///< stays so where nothing is
  Point where{};           ///< in the middle of the wall at its thinnest place
  double thinner_mm2 = 0;  ///< of the surface, both sides of a wall counted
  double surface_mm2 = 0;  ///< all of it
};

/// Sides within this angle of being parallel bound a wall. Where they meet in an edge they are a
/// wedge, which has no thickness at its tip and is no wall; sharper than the second angle it is
/// one all the same, since it is thinner than a length L for more than 11 L.
inline constexpr double widest_taper_deg = 20;
inline constexpr double sharpest_wedge_deg = 5;

/// Looks for walls thinner than `limit_mm`. From points of the surface the thickness is the
/// distance to the surface opposite, along the inward normal of the triangle, and counts where the
/// two triangles look away from each other to within `widest_taper_deg`. The points are the middle
/// of every triangle and, in triangles of more than limit_mm^2, rows of points about as far apart
/// as the limit; coarser ones where that would be more than 400 000, for a bounded time. Between
/// parallel faces the thickness is that of the mesh, to rounding; along a taper the least one is
/// missed by at most half the points' distance times tan(taper). Curved walls are as thick as their
/// chords leave them. Slivers so low that float32 may have turned them by 5 degrees are left out.
/// Deterministic; n log n in time, about 300 bytes a triangle. Precondition: the mesh passes an
/// audit (audit.h). limit_mm > 0.
ThinWalls thin_walls(const TriangleMesh& sound, double limit_mm);

}  // namespace latticast
