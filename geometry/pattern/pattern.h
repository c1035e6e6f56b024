// SPDX-License-Identifier: GPL-3.0-or-later
// A segment's strands, drawn flat: the tube is unrolled at the lattice's mid radius R_c, u = R_c
// Theta runs around it and z along it. The plane is periodic in u; a strand may run on through many
// periods.
#pragma once

#include <vector>

#include "design/design.h"
#include "geometry/pattern/plane_curve.h"

namespace latticast {

/// One strand's filled outline, or an arc's of it: a simple polygon, counter-clockwise seen from
/// outside the tube, in the plane before it is made periodic, 0 <= z <= length. Where an end of the
/// segment cuts it into several parts, edges there and back along the end join them.
struct Strand {
  std::vector<PlanePoint> outline;
  std::vector<DrawnCurve> curves{};  ///< that the outline follows
  std::vector<CurveRange> traces{};  ///< of the edge from each point to the next, on `curves`;
                                     ///< empty: every edge is a line of its own
};

/// The strand moved within the plane, its curves with it.
Strand moved(Strand strand, PlanePoint by);

/// How far what is drawn may be from what was meant.
struct DrawingError {
  double distance_mm = 0;  ///< of outlines from the true ones
  double area_mm2 = 0;     ///< of the united strands

  /// Two drawings in one: the larger distance, both areas.
  DrawingError& operator+=(const DrawingError& other);
};

/// All strands of one segment. They overlap where they cross; their union is the lattice.
struct Pattern {
  double circumference_mm = 0;  ///< period in u
  double length_mm = 0;
  std::vector<Strand> strands;
  DrawingError error{};  ///< of curves drawn as chords; none for straight outlines
};

/// Draws the rings and strands of a lattice. Strands keep their width square to themselves at R_c
/// and are cut level at both ends (docs/geometry.md#the-unrolled-plane); strand 0 of every family
/// starts at u = 0. Arcs of horseshoe columns become chords within `flatness_mm` of the circle.
/// Columns that overlap their neighbours are drawn as they are: united, they are one net
/// (overlapping_neighbours()). Precondition: a validated segment with a lattice. Throws CannotDraw
/// for curved strands that do not close on the segment's length or fold over themselves.
Pattern draw_lattice(const Segment& segment, double flatness_mm);

/// Draws a closed sleeve: the whole plane, as one strand, at the given radius.
Pattern draw_sleeve(double radius_mm, double length_mm);

}  // namespace latticast
