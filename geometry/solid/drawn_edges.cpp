// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/drawn_edges.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

void add_outline(const Strand& strand, DrawnEdges& drawn) {
  const auto first = static_cast<std::uint32_t>(drawn.curves.size());
  const std::size_t n = strand.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    DrawnEdge edge{strand.outline[i], strand.outline[(i + 1) % n], {own_line, 0, 1}};
    if (i < strand.traces.size()) edge.range = strand.traces[i];
    if (edge.range.curve != own_line) edge.range.curve += first;
    drawn.edges.push_back(edge);
  }
  drawn.curves.insert(drawn.curves.end(), strand.curves.begin(), strand.curves.end());
}

// How many circumferences lie between a place and where the edge was drawn. An edge that winds
// around the tube more than once is found by its height; a level one is the same on every turn.
double turns_between(const DrawnEdge& edge, PlanePoint place, double circumference) {
  double part = 0.5;
  if (std::abs(edge.to.u - edge.from.u) > circumference && edge.from.z != edge.to.z) {
    part = std::clamp((place.z - edge.from.z) / (edge.to.z - edge.from.z), 0.0, 1.0);
  }
  return std::round((place.u - std::lerp(edge.from.u, edge.to.u, part)) / circumference);
}

// Where the foot of a point on the edge lies: 0 at its start, 1 at its end.
double foot(const DrawnEdge& edge, PlanePoint p) {
  const double du = edge.to.u - edge.from.u;
  const double dz = edge.to.z - edge.from.z;
  const double square = du * du + dz * dz;
  if (square == 0) return 0;
  return std::clamp(((p.u - edge.from.u) * du + (p.z - edge.from.z) * dz) / square, 0.0, 1.0);
}

}  // namespace

DrawnEdges drawn_edges(std::span<const Pattern> sheets) {
  DrawnEdges drawn;
  if (!sheets.empty()) drawn.circumference_mm = sheets.front().circumference_mm;
  for (const Pattern& sheet : sheets) {
    for (const Strand& strand : sheet.strands) add_outline(strand, drawn);
  }
  return drawn;
}

EdgeFeet feet_on(const DrawnEdge& edge, PlanePoint a, PlanePoint b, double circumference_mm) {
  const double turns = turns_between(edge, middle(a, b), circumference_mm);
  const double shift = turns * circumference_mm;
  return {turns, foot(edge, {a.u - shift, a.z}), foot(edge, {b.u - shift, b.z})};
}

std::optional<TracedCurve> traced(const DrawnEdges& drawn, EdgeOrigin origin, PlanePoint a,
                                  PlanePoint b) {
  if (!is_drawn(origin)) return std::nullopt;
  const DrawnEdge& edge = drawn.edges[origin];
  const EdgeFeet feet = feet_on(edge, a, b, drawn.circumference_mm);
  const CurveRange& range = edge.range;
  return TracedCurve{.curve = range.curve == own_line
                                  ? DrawnCurve{.shape = StraightLine{edge.from, edge.to}}
                                  : drawn.curves[range.curve],
                     .from = std::lerp(range.from, range.to, feet.a),
                     .to = std::lerp(range.from, range.to, feet.b),
                     .turns = feet.turns};
}

}  // namespace latticast
