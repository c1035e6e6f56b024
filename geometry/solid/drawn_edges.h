// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance of edges: which drawn curve an edge of the united plane follows, and which piece of
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/pattern/pattern.h"

namespace latticast {

/// What an edge of the plane comes from: the index of a drawn edge (DrawnEdges), or one of the four
/// kinds below. Where edges coincide, the smallest index stays: a drawn edge before a cut, and of
/// two drawn edges the one that was drawn first.
using EdgeOrigin = std::uint32_t;
inline constexpr EdgeOrigin on_cut = 0xFFFFFFFC;            ///< a cut across the material
inline constexpr EdgeOrigin on_sector_line = 0xFFFFFFFD;    ///< a line between two sectors
inline constexpr EdgeOrigin on_segment_start = 0xFFFFFFFE;  ///< an end of material at z = 0
inline constexpr EdgeOrigin on_segment_end = 0xFFFFFFFF;    ///< an end of material at z = length
constexpr bool is_drawn(EdgeOrigin origin) {
  return origin < on_cut;
}

/// One edge of a strand's outline, and the curve that it stands for.
struct DrawnEdge {
  PlanePoint from;
  PlanePoint to;
  CurveRange range;
};

/// The outlines' edges of all patterns that are arranged together, in the order in which they were
/// drawn, with one list of curves.
struct DrawnEdges {
  double circumference_mm = 0;
  std::vector<DrawnCurve> curves;
  std::vector<DrawnEdge> edges;
};

/// A piece of a curve, t = from .. to. `turns` circumferences are to be added to the curve's u.
struct TracedCurve {
  DrawnCurve curve;
  double from = 0;
  double to = 0;
  double turns = 0;
};

DrawnEdges drawn_edges(std::span<const Pattern> sheets);

/// Where an edge a -> b lies on a drawn edge: the feet of a and b, 0 at its start and 1 at its end,
/// after `turns` circumferences have been taken off their u.
struct EdgeFeet {
  double turns = 0;
  double a = 0;
  double b = 0;
};
EdgeFeet feet_on(const DrawnEdge& edge, PlanePoint a, PlanePoint b, double circumference_mm);

/// The piece of its drawn curve that an edge a -> b stands for: where the feet of a and b on the
/// drawn edge lie. a and b may be a whole number of circumferences away from where it was drawn.
/// Nothing for edges that were not drawn.
std::optional<TracedCurve> traced(const DrawnEdges& drawn, EdgeOrigin origin, PlanePoint a,
                                  PlanePoint b);

}  // namespace latticast
