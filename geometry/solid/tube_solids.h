// SPDX-License-Identifier: GPL-3.0-or-later
// Meshed solids of one segment, its lattice and its liner: reliefs of the united plane, wrapped
// around the tube (docs/geometry.md).
#pragma once

#include "design/design.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/solid/solid_error.h"

namespace latticast {

class LatticeDrawing;

struct SolidOptions {
  double tolerance_mm = 0.01;   ///< largest chord error
  double start_z_mm = 0;        ///< where the segment begins along the actuator
  double twist_rad_per_mm = 0;  ///< largest twist that the mesh will be given later (preview)
  double stretch_radius =
      1;               ///< largest factor by which its outer radius will grow later (preview)
  double stretch = 1;  ///< largest factor by which short lines on it will grow later (preview)
  int refinement =
      0;  ///< each doubles sectors and levels, and makes four cuts along the tube of one
  double least_step_mm = 0;  ///< of the plane's grid; finer ones would be lost later (preview)
};

/// A mesh with what the planar region says that it must be.
struct Solid {
  TriangleMesh mesh;
  double volume_mm3 = 0;  ///< of the drawn region, exact: area x (R_o^2 - R_m^2) / (2 R_c); chords
                          ///< of horseshoe arcs enclose the arcs' area, those of fillets do not
  double volume_bound_mm3 = 0;  ///< how far a mesh within the tolerance may be from it, its
                                ///< coordinates rounded to float32
  int pieces = 0;               ///< connected components
  int genus = 0;                ///< summed over the pieces
  SolidError error{};           ///< against what the design means, arcs and all; coordinates exact
};

/// The lattice layer R_m..R_o of a segment. Precondition: the segment has a lattice.
/// Arcs and fillets stay within the tolerance of the true ones at every radius, chords and walls
/// together. Throws GeometryError, CannotDraw (geometry_error.h, cannot_draw.h).
Solid lattice_solid(LatticeDrawing& drawing, const SolidOptions& options);

/// Of a segment that is drawn for this solid alone.
Solid lattice_solid(const Segment& segment, const SolidOptions& options);

/// The liner R_i..R_m, open at both ends.
Solid liner_solid(const Segment& segment, const SolidOptions& options);

}  // namespace latticast
