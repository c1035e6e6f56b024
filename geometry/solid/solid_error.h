// SPDX-License-Identifier: GPL-3.0-or-later
// Error bound of a meshed solid against the solid that it stands for, from how it was made
// (docs/geometry.md#how-far-a-file-may-be-from-what-was-drawn).
#pragma once

#include <span>
#include <vector>

namespace latticast {

struct Region;
struct TriangleMesh;

/// Estimates from above. The true solid has round floors and ceilings, arcs in place of their
/// chords, and walls that run straight towards the axis.
struct SolidError {
  double surface_mm = 0;  ///< largest distance of a point of the mesh from the true surface
  double volume_mm3 = 0;  ///< of the volume enclosed
};

/// Of the relief (relief.h) that stands on a region: `radii_mm` are its levels, the region's plane
/// is unrolled at `drawn_radius_mm`, `steepness` as for wall_radii, one for each layer. Derived in
/// docs/geometry.md. Coordinates are taken to be exact.
SolidError solid_error(const Region& region, const std::vector<std::vector<double>>& radii_mm,
                       double drawn_radius_mm, std::span<const double> steepness);

/// The largest distance that float32, which mesh files hold, moves a vertex by. 0 for no vertices.
double rounding_mm(const TriangleMesh& mesh);

}  // namespace latticast
