// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of a strand that is a chain of links: polygons between cross-sections, cut level at both
// ends of the segment, without what the cut leaves loose.
#pragma once

#include <functional>

#include "geometry/pattern/placed_strand.h"

namespace latticast {

/// A corner of an outline, and what the edge from it to the next one stands for.
struct OutlineCorner {
  PlanePoint point;
  CurveRange edge;
};

/// An outline, and the curves that its edges name.
struct TracedOutline {
  std::vector<OutlineCorner> corners;
  std::vector<DrawnCurve> curves;
};

/// A chain of equal links, endless in both directions. Link i lies between the joints i and i + 1;
/// joint 0 is the start of the chord line.
struct LinkChain {
  StrandFrame frame;
  double link_chord_mm = 0;
  double length_mm = 0;    ///< of the segment, along z
  double flatness_mm = 0;  ///< a cross-section less than this inside counts as outside
  int steps = 1;           ///< from one joint to the next

  /// One end of the cross-section number `step` of a link, 0 to steps; `outer` is the end on the
  /// side to which the link bulges. Both links of a joint have the same ends there, bit for bit.
  std::function<PlanePoint(int link, int step, bool outer)> edge;

  /// A side of a whole link, from joint to joint, its parameter being step/steps.
  std::function<DrawnCurve(int link, bool outer)> side;

  /// What fills the corner at a joint; empty where links join smoothly.
  std::function<TracedOutline(int joint)> corner;
};

/// From the middle of the strand to both ends: what lies beyond its first way out is loose and left
/// out. Polygons are counter-clockwise. The error is left to the caller.
DrawnStrand draw_chain(const LinkChain& chain);

}  // namespace latticast
