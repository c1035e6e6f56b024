// SPDX-License-Identifier: GPL-3.0-or-later
// A relief gives the layers of a region of the unrolled plane their radial intervals, one above the
// other; wrapping it around the tube gives a closed solid. Floors, ceilings and walls share
// vertices, so nothing is left to sew or to intersect.
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/solid/plane_mesh.h"

namespace latticast {

struct Relief {
  PlaneMesh plane;
  /// Of each layer: ascending, at least two: floor, levels that divide the walls, ceiling. The next
  /// layer's floor is this one's ceiling. The first floor may be 0, the axis of a solid rod, for
  /// regions that run all the way around.
  std::vector<std::vector<double>> radii_mm;
  double start_z_mm = 0;  ///< where the segment begins along the actuator
};

/// What a relief's solid must be, counted in the plane.
struct ReliefTopology {
  int pieces = 0;  ///< connected components
  int genus = 0;   ///< summed over the pieces
};

/// From the layers alone: a solid M of stacked layers has the Euler characteristic sum of
/// chi(layer) less sum of chi(what neighbouring layers share), its surface twice that; bands that
/// reach the axis are discs. Preconditions: of two neighbouring layers, one lies within the other
/// at every edge between them; no void is enclosed.
ReliefTopology topology(const Relief& relief);

/// Wraps a relief into one closed, outward-oriented mesh with shared vertices.
///
/// Guarantees: every edge has two triangles; pieces and genus are those of topology(); volume
/// equals the sum over layers of area x (r_ceiling^2 - r_floor^2) / (2 R), R being the radius where
/// the plane was unrolled, up to rounding. Precondition: of two neighbouring layers, one lies
/// within the other (a groove's floor within its shell), or they would meet in a line. Sectors are
/// flat: their corners lie at radius r sqrt(D / sin D), D the sector's angle, which makes the
/// prism's section exactly as large as the circle's. A wall between two radii is a twisted
/// quadrangle, filled by four triangles around its middle, which leaves its volume unbiased;
/// docs/geometry.md derives it.
TriangleMesh wrap(const Relief& relief);

/// Largest distance between the wrapped surface of radius r and the cylinder, for sectors of angle
/// D: the larger of r (sqrt(D / sin D) - 1) and r (1 - sqrt(D / sin D) cos(D / 2)).
double chord_error_mm(double radius_mm, double sector_angle_rad);

/// Largest distance between a wall `depth_mm` high, from one level to the next, and the true
/// helicoid.
double wall_error_mm(double depth_mm, double sector_angle_rad, double steepness);

/// Fewest sectors (at least 12) that keep the chord error within a tolerance.
int sectors_for(double radius_mm, double tolerance_mm);

/// The radii between floor and ceiling that keep the walls within `tolerance_mm` of the true
/// helicoids. `steepness` is the largest |sin| of the angle between an outline and the
/// circumference at any radius of the layer (an outline is steepest at the floor), 0 for walls
/// along rings or along the tube only, which are flat.
std::vector<double> wall_radii(double floor_mm, double ceiling_mm, double sector_angle_rad,
                               double steepness, double tolerance_mm);

}  // namespace latticast
