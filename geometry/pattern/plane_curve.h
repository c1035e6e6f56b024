// SPDX-License-Identifier: GPL-3.0-or-later
// Parametric curves in the unrolled plane: what the edges of a drawn outline stand for.
#pragma once

#include <cstdint>
#include <limits>
#include <variant>

#include "geometry/pattern/plane_point.h"

namespace latticast {

struct StraightLine {
  PlanePoint from;
  PlanePoint to;
};

/// Angles count from u towards z; `to_rad` below `from_rad` runs clockwise.
struct CircularArc {
  PlanePoint centre;
  double radius_mm = 0;
  double from_rad = 0;
  double to_rad = 0;
};

/// A half wave's offset curve: at a distance from t = amplitude sin(pi s/chord), s along its chord
/// line, t to the side to which it bulges.
struct SinusoidOffset {
  PlanePoint start;  ///< of the centre line, on the chord line
  PlanePoint along;  ///< unit vectors
  PlanePoint bulge;
  double chord_mm = 0;
  double amplitude_mm = 0;
  double offset_mm = 0;  ///< from the centre line, positive on the outer side
};

/// Every curve has a parameter t that runs from 0 at its start to 1 at its end, at constant speed
/// on lines and arcs, s = t chord on the centre line of sinusoids. Curves lie in the plane before
/// it is made periodic.
using PlaneCurve = std::variant<StraightLine, CircularArc, SinusoidOffset>;

PlanePoint point_at(const PlaneCurve& curve, double t);

/// The same curve elsewhere.
PlaneCurve moved(const PlaneCurve& curve, PlanePoint by);

/// What a curve bounds.
enum class CurvePart : std::uint8_t {
  other,
  ring,    ///< a side of a ring
  strand,  ///< a side of a strand, or a cut across it between two links
  joint,   ///< the round corner between two links of a strand
  fillet,
};

/// A curve, and whose it is. Indices that do not apply are -1.
struct DrawnCurve {
  PlaneCurve shape;
  CurvePart part = CurvePart::other;
  int family = -1;  ///< index of the strand's family in the lattice
  int strand = -1;  ///< index in the family; of a ring, along the tube
  int link = -1;    ///< of the strand's path, from the start of the segment
  int side = 0;     ///< seen along the strand (a ring: along u): -1 left, 1 right, 0 across it
};

/// An edge stands for the piece t = from .. to of a curve, in the edge's direction.
struct CurveRange {
  std::uint32_t curve = 0;  ///< an index; `own_line`: the edge is the curve itself
  double from = 0;
  double to = 1;
};
inline constexpr std::uint32_t own_line = std::numeric_limits<std::uint32_t>::max();

}  // namespace latticast
