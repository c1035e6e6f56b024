// SPDX-License-Identifier: GPL-3.0-or-later
// Flat pattern of a segment's lattice: its development at the mid radius, slit along Theta = 0, to
// be cut out of a sheet and rolled up.
#pragma once

#include <vector>

#include "design/design.h"
#include "geometry/pattern/pattern.h"

namespace latticast {

class LatticeDrawing;

/// A connected part of the pattern. Outlines are closed (the last point is joined to the first) and
/// simple: no point occurs twice, no two edges cross or overlap. Those of one pattern have no point
/// in common.
struct FlatPiece {
  std::vector<PlanePoint> outer;               ///< counter-clockwise
  std::vector<std::vector<PlanePoint>> holes;  ///< clockwise, each inside `outer`
};

/// u = R_c Theta to the right, z up, as seen from outside the tube.
struct FlatPattern {
  double radius_mm = 0;         ///< R_c, where strand widths are measured
  double circumference_mm = 0;  ///< 2 pi R_c, the pattern's width
  double length_mm = 0;         ///< the segment's, the pattern's height
  std::vector<FlatPiece> pieces;
  double area_mm2 = 0;   ///< of the material, counted in grid steps: outlines less holes
  DrawingError error{};  ///< against what the design means: chords, grid, closed touching points
};

/// Unites the strands with their fillets and slits the union at Theta = 0. Guarantees:
/// - every point lies in 0 <= u <= circumference, 0 <= z <= length, on the integer grid (a whole
///   number of equal steps along u, and of others along z);
/// - what the slit parts has its points at the same z on either side, so that the rolled sheet
///   closes;
/// - arcs and fillets are chords within `tolerance_mm` (> 0) of the true ones; straight outlines
///   are within 1.5 steps (PlaneGrid) of theirs;
/// - where material would hang together in a single point, it is joined by a diamond of half-width
///   `tolerance_mm` (region.h). A slit through the tip of an opening makes such a point, too.
/// A lattice wider than its spacing gives one piece without holes, the rectangle; a lattice whose
/// rings do not fit on the segment and that has no grid gives no piece.
/// Time n log n in the outline's pieces, plus, where there is more than one piece, those of the
/// pieces around a hole for every hole. Precondition: a validated segment with a lattice. Throws
/// CannotDraw, and GeometryError (geometry_error.h) also for strands thinner than 16
/// steps.
FlatPattern flat_pattern(LatticeDrawing& drawing, double tolerance_mm);

/// Of a segment that is drawn for this pattern alone.
FlatPattern flat_pattern(const Segment& segment, double tolerance_mm);

}  // namespace latticast
