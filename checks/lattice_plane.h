// SPDX-License-Identifier: GPL-3.0-or-later
// A segment's united lattice as checks look at it: outlines and parts in the unrolled plane.
#pragma once

#include <vector>

#include "design/design.h"
#include "geometry/pattern/pattern.h"

namespace latticast {

class LatticeDrawing;

/// A closed outline of the material, which lies on its left. Points on a straight line are left
/// out but for its ends; u runs on past the seam, so that neighbours are never a turn apart.
struct Outline {
  std::vector<PlanePoint> points;
  double around_mm = 0;  ///< of the way back to the first point: 0, or a turn of the tube

  /// A hole in the lattice that does not run around the tube.
  bool is_cell() const;
};

/// A connected part of the lattice.
struct LatticePart {
  double area_mm2 = 0;
  PlanePoint place;  ///< on its material
};

struct LatticePlane {
  double circumference_mm = 0;
  double length_mm = 0;
  std::vector<Outline> outlines;
  std::vector<LatticePart> parts;  ///< largest first
  double area_mm2 = 0;
};

/// The united lattice with its fillets; arcs are chords within 0.01 mm, and within a twentieth of
/// the thinnest strand and the fillet. Throws CannotDraw and GeometryError
/// (geometry_error.h).
LatticePlane lattice_plane(LatticeDrawing& drawing);

/// Twice the radius of the largest circle in a simple polygon, from below: within `slack_mm`, and
/// within a micrometre where only that tells whether it is more than `enough_mm`; some value above
/// `enough_mm` as soon as it is known to be more. 0 for a polygon without area.
double inscribed_width_mm(const std::vector<PlanePoint>& polygon, double enough_mm,
                          double slack_mm);

}  // namespace latticast
