// SPDX-License-Identifier: GPL-3.0-or-later
// Outline of one period of the united plane, divided anew along its curves: what the triangles of a
// unit cell start from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/solid/region.h"

namespace latticast {

/// The piece of a region that repeats: the first sectors of its grid, between two of the cuts that
/// it was united with.
struct Period {
  int sectors = 1;
  std::int32_t z_from = 0;  ///< grid steps
  std::int32_t z_to = 0;
  double shift_mm = 0;    ///< (u, z_from) repeats at (u + shift, z_to)
  bool mirrored = false;  ///< the ends are mirrors of what lies beyond, and need not be alike
};

/// How finely a period is divided.
struct PeriodDivision {
  double size_mm = 0;        ///< longest side of a triangle, about
  double most_turn_rad = 0;  ///< of a curve along one side
};

/// A rectangle of the plane, u counted from its left side.
struct PeriodBox {
  double width_mm = 0;
  double z_from_mm = 0;
  double z_to_mm = 0;
};
PeriodBox box_of(const PlaneGrid& grid, const Period& period);

/// What an edge stands for: the piece t = from .. to of a curve, or the line between its ends.
struct OutlinePiece {
  std::optional<DrawnCurve> curve;
  double from = 0;
  double to = 1;
  double offset_mm = 0;  ///< to be added to the curve's u
  Layers left = 0;       ///< layers that are material on the edge's left
  Layers right = 0;

  /// Its place a share `t` of the way from a to b.
  PlanePoint at(double t, PlanePoint a, PlanePoint b) const;
};

struct PeriodOutline {
  std::vector<PlanePoint> points;  ///< ends of edges, and places on the box's sides that edges
                                   ///< beyond lead to
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<OutlinePiece> pieces;  ///< one an edge
};

/// Edges that follow one curve are taken together and divided evenly, so that neither the chords
/// nor the sectors of the drawing are seen. Ends of curves stay where the grid has them, places
/// between lie on the curve.
PeriodOutline period_outline(const Region& region, const Period& period,
                             const PeriodDivision& division);

}  // namespace latticast
