// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/rounded_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace latticast {
namespace {

constexpr int cells_around = 128;
constexpr double most_rows = 4096;

// The parameter of the place on the arc that is nearest to a point, if the point is that near.
std::optional<double> place_on(const CircularArc& arc, PlanePoint p, double tolerance) {
  if (std::abs(distance(p, arc.centre) - arc.radius_mm) > tolerance) return std::nullopt;
  const double middle_rad = 0.5 * (arc.from_rad + arc.to_rad);
  const double angle = std::atan2(p.z - arc.centre.z, p.u - arc.centre.u);
  const double off = std::remainder(angle - middle_rad, 2 * std::numbers::pi);
  const double t = 0.5 + off / (arc.to_rad - arc.from_rad);
  const double beyond = (std::max(-t, t - 1)) * std::abs(arc.to_rad - arc.from_rad);
  if (beyond * arc.radius_mm > tolerance) return std::nullopt;
  return std::clamp(t, 0.0, 1.0);
}

// A range on one of the drawn curves, moved by whole turns.
struct Found {
  std::uint32_t curve = own_line;
  double from = 0;
  double to = 0;
  double turns = 0;
};

std::optional<Found> on_chord(const DrawnEdges& drawn, const DrawnEdge& edge, PlanePoint a,
                              PlanePoint b, double tolerance) {
  const EdgeFeet feet = feet_on(edge, a, b, drawn.circumference_mm);
  const double shift = feet.turns * drawn.circumference_mm;
  const auto is_near = [&](PlanePoint p, double part) {
    return distance(p, {std::lerp(edge.from.u, edge.to.u, part) + shift,
                        std::lerp(edge.from.z, edge.to.z, part)}) <= tolerance;
  };
  if (!is_near(a, feet.a) || !is_near(b, feet.b)) return std::nullopt;
  const CurveRange& range = edge.range;
  return Found{range.curve, std::lerp(range.from, range.to, feet.a),
               std::lerp(range.from, range.to, feet.b), feet.turns};
}

std::optional<Found> on_arc(const DrawnEdges& drawn, const DrawnEdge& edge, PlanePoint a,
                            PlanePoint b, double tolerance) {
  if (edge.range.curve == own_line) return std::nullopt;
  const auto* arc = std::get_if<CircularArc>(&drawn.curves[edge.range.curve].shape);
  if (arc == nullptr) return std::nullopt;
  const double turns = feet_on(edge, a, b, drawn.circumference_mm).turns;
  const double shift = turns * drawn.circumference_mm;
  const auto from = place_on(*arc, {a.u - shift, a.z}, tolerance);
  const auto to = place_on(*arc, {b.u - shift, b.z}, tolerance);
  if (!from || !to) return std::nullopt;
  const PlanePoint mid = middle(a, b);
  if (!place_on(*arc, {mid.u - shift, mid.z}, tolerance)) return std::nullopt;
  // An edge of a whole circle may lie across its start.
  const double around = std::abs(*to - *from) > 0.5 ? std::copysign(1.0, *from - *to) : 0;
  return Found{edge.range.curve, *from, *to + around, turns};
}

// Edges first .. last - 1 of an outline, which no drawn curve explains.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
};

class Tracing {
 public:
  Tracing(const DrawnEdges& drawn, const RoundedOutlineOptions& options, Strand& outline)
      : drawn_(drawn), options_(options), outline_(outline) {
    outline.traces.assign(outline.outline.size(), {own_line, 0, 1});
    is_traced_.assign(outline.outline.size(), 0);
  }

  PlanePoint point(std::size_t i) const { return outline_.outline[i % outline_.outline.size()]; }

  void set(std::size_t edge, EdgeOrigin origin, const Found& found) {
    is_traced_[edge] = 1;
    const bool is_own = found.curve == own_line;
    const std::uint32_t key = is_own ? origin : found.curve;
    const auto [at, is_new] =
        index_.try_emplace({is_own, key, static_cast<int>(found.turns)},
                           static_cast<std::uint32_t>(outline_.curves.size()));
    if (is_new) {
      const DrawnEdge& drawn = drawn_.edges[origin];
      DrawnCurve curve = is_own ? DrawnCurve{.shape = StraightLine{drawn.from, drawn.to}}
                                : drawn_.curves[found.curve];
      curve.shape = moved(curve.shape, {found.turns * drawn_.circumference_mm, 0});
      outline_.curves.push_back(curve);
    }
    outline_.traces[edge] = {at->second, found.from, found.to};
  }

  // Between drawn curves runs go around a disc; a corner towards the outside parts two of them.
  void add_fillets() {
    const std::size_t n = is_traced_.size();
    const auto traced = std::find(is_traced_.begin(), is_traced_.end(), 1);
    const auto start = static_cast<std::size_t>(traced - is_traced_.begin());
    for (std::size_t i = start; i < start + n;) {
      if (is_traced_[i % n] != 0) {
        ++i;
        continue;
      }
      Run run{i, i + 1};
      while (run.last < start + n && is_traced_[run.last % n] == 0 && !is_outward(run.last)) {
        ++run.last;
      }
      add_fillet(run);
      i = run.last;
    }
  }

 private:
  bool is_outward(std::size_t i) const {
    const std::size_t n = is_traced_.size();
    return cross(point(i + n - 1), point(i), point(i + 1)) >
           options_.rounding_mm * distance(point(i + n - 1), point(i + 1));
  }

  // The disc of the fillet lies on the right of its outline, which runs around it clockwise.
  void add_fillet(const Run& run) {
    const PlanePoint a = point(run.first);
    const PlanePoint b = point(run.last);
    const double chord = distance(a, b);
    const double radius = options_.radius_mm;
    if (chord == 0 || chord > 2 * radius) return;
    const double height = std::sqrt(radius * radius - 0.25 * chord * chord);
    const PlanePoint mid = middle(a, b);
    CircularArc arc{
        .centre = {mid.u + height * (b.z - a.z) / chord, mid.z - height * (b.u - a.u) / chord},
        .radius_mm = radius};
    arc.from_rad = std::atan2(a.z - arc.centre.z, a.u - arc.centre.u);
    arc.to_rad = arc.from_rad - 2 * std::asin(std::min(1.0, 0.5 * chord / radius));
    const double tolerance = options_.flatness_mm + options_.rounding_mm;
    std::vector<double> places;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const auto place = place_on(arc, point(i), tolerance);
      const bool bends = i == run.last || place_on(arc, middle(point(i), point(i + 1)), tolerance);
      if (!place || !bends) return;
      places.push_back(*place);
    }
    const auto curve = static_cast<std::uint32_t>(outline_.curves.size());
    outline_.curves.push_back({.shape = arc, .part = CurvePart::fillet, .side = -1});
    for (std::size_t i = run.first; i < run.last; ++i) {
      outline_.traces[i % is_traced_.size()] = {curve, places[i - run.first],
                                                places[i - run.first + 1]};
    }
  }

  const DrawnEdges& drawn_;
  const RoundedOutlineOptions& options_;
  Strand& outline_;
  std::vector<char> is_traced_;
  std::map<std::tuple<bool, std::uint32_t, int>, std::uint32_t> index_;
};

}  // namespace

RoundedOutlineTracer::RoundedOutlineTracer(const Pattern& pattern,
                                           const RoundedOutlineOptions& options)
    : options_(options),
      length_mm_(pattern.length_mm),
      drawn_(drawn_edges({&pattern, 1})),
      columns_(cells_around),
      rows_(static_cast<int>(
          std::clamp(cells_around * pattern.length_mm / pattern.circumference_mm, 1.0, most_rows))),
      cells_(static_cast<std::size_t>(columns_) * rows_) {
  for (EdgeOrigin i = 0; i < drawn_.edges.size(); ++i) add_to_cells(i);
}

// Row by row, because an edge may wind around the tube many times.
void RoundedOutlineTracer::add_to_cells(EdgeOrigin index) {
  const DrawnEdge& edge = drawn_.edges[index];
  const double margin = options_.flatness_mm + options_.rounding_mm;
  const PlanePoint low = edge.from.z < edge.to.z ? edge.from : edge.to;
  const PlanePoint high = edge.from.z < edge.to.z ? edge.to : edge.from;
  const double row_height = length_mm_ / rows_;
  const double cell_width = drawn_.circumference_mm / columns_;
  const auto row_of = [&](double z) {
    return std::clamp(static_cast<int>(std::floor(z / row_height)), 0, rows_ - 1);
  };
  const auto u_at = [&](double z) {
    if (high.z == low.z) return low.u;
    return std::lerp(low.u, high.u, std::clamp((z - low.z) / (high.z - low.z), 0.0, 1.0));
  };
  for (int row = row_of(low.z - margin); row <= row_of(high.z + margin); ++row) {
    double left = u_at(row * row_height - margin);
    double right = u_at((row + 1) * row_height + margin);
    if (high.z == low.z) right = high.u;
    if (left > right) std::swap(left, right);
    const auto first = static_cast<std::int64_t>(std::floor((left - margin) / cell_width));
    const auto last = std::min<std::int64_t>(
        static_cast<std::int64_t>(std::floor((right + margin) / cell_width)), first + columns_ - 1);
    for (std::int64_t cell = first; cell <= last; ++cell) {
      const std::int64_t column = ((cell % columns_) + columns_) % columns_;
      cells_[static_cast<std::size_t>(row) * columns_ + column].push_back(index);
    }
  }
}

const std::vector<EdgeOrigin>& RoundedOutlineTracer::near(PlanePoint place) const {
  const double turns = place.u / drawn_.circumference_mm;
  const auto column =
      std::min(static_cast<int>((turns - std::floor(turns)) * columns_), columns_ - 1);
  const int row = std::clamp(static_cast<int>(place.z / length_mm_ * rows_), 0, rows_ - 1);
  return cells_[static_cast<std::size_t>(row) * columns_ + column];
}

void RoundedOutlineTracer::trace(Strand& outline) const {
  Tracing tracing(drawn_, options_, outline);
  const double arc_tolerance = options_.flatness_mm + options_.rounding_mm;
  for (std::size_t i = 0; i < outline.outline.size(); ++i) {
    const PlanePoint a = tracing.point(i);
    const PlanePoint b = tracing.point(i + 1);
    const std::vector<EdgeOrigin>& candidates = near(middle(a, b));
    std::optional<Found> found;
    for (auto c = candidates.begin(); c != candidates.end() && !found; ++c) {
      found = on_chord(drawn_, drawn_.edges[*c], a, b, options_.rounding_mm);
      if (found) tracing.set(i, *c, *found);
    }
    for (auto c = candidates.begin(); c != candidates.end() && !found; ++c) {
      found = on_arc(drawn_, drawn_.edges[*c], a, b, arc_tolerance);
      if (found) tracing.set(i, *c, *found);
    }
  }
  tracing.add_fillets();
}

}  // namespace latticast
