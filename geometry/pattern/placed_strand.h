// SPDX-License-Identifier: GPL-3.0-or-later
// A strand placed in the unrolled plane: its path, its chord line and its width. What every home of
// a path (straight_path.h, horseshoe_path.h) takes and gives.
#pragma once

#include <vector>

#include "design/strand_path.h"
#include "geometry/pattern/pattern.h"

namespace latticast {

/// One strand. Its chord line starts at (start_u, 0) and runs at `angle_deg` from the circumference
/// to z = length.
template <class Path>
struct Placed {
  Path shape;
  double start_u_mm = 0;
  double angle_deg = 90;
  double width_mm = 0;
  double length_mm = 0;  ///< of the segment, along z
};

using PlacedStrand = Placed<StrandPath>;

/// Outlines of one strand, cut level at both ends of the segment.
struct DrawnStrand {
  std::vector<Strand> links;  ///< one polygon a link; one for all of a straight strand
  DrawingError error{};       ///< of the chords that were made
  bool in_one_piece = true;   ///< false: a link reaches past an end so far that it parts the strand
};

/// Flatness that is fine enough to tell whether a strand is in one piece.
constexpr double trial_flatness_mm(double width_mm) {
  return 0.01 * width_mm;
}

/// Where a strand's links are drawn: s along its chord line, t to the right of it.
struct StrandFrame {
  PlanePoint origin;
  PlanePoint along;  ///< unit vector
  PlanePoint right;  ///< unit vector

  PlanePoint at(double s, double t) const {
    return {origin.u + s * along.u + t * right.u, origin.z + s * along.z + t * right.z};
  }
};

/// The frame of a chord line; that of 90 degrees is exactly axial.
StrandFrame strand_frame(double start_u_mm, double angle_deg);

}  // namespace latticast
