// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/period_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace latticast {
namespace {

constexpr double same_curve_mm = 1e-3;  // far below every width

/// An edge of the region, in the period's own box.
struct BoxEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Layers left = 0;
  Layers right = 0;
  std::optional<TracedCurve> curve;
};

BoxEdge reversed(BoxEdge edge) {
  std::swap(edge.from, edge.to);
  std::swap(edge.left, edge.right);
  if (edge.curve) std::swap(edge.curve->from, edge.curve->to);
  return edge;
}

bool follow_one_curve(const BoxEdge& a, const BoxEdge& b) {
  if (!a.curve || !b.curve || a.curve->turns != b.curve->turns) return false;
  const PlaneCurve& p = a.curve->curve.shape;
  const PlaneCurve& q = b.curve->curve.shape;
  return p.index() == q.index() && distance(point_at(p, 0), point_at(q, 0)) < same_curve_mm &&
         distance(point_at(p, 1), point_at(q, 1)) < same_curve_mm &&
         distance(point_at(p, 0.4), point_at(q, 0.4)) < same_curve_mm;
}

double turn_rad(const TracedCurve& curve) {
  const double share = std::abs(curve.to - curve.from);
  if (const auto* arc = std::get_if<CircularArc>(&curve.curve.shape)) {
    return share * std::abs(arc->to_rad - arc->from_rad);
  }
  if (const auto* wave = std::get_if<SinusoidOffset>(&curve.curve.shape)) {
    return share * 2 * std::atan(std::numbers::pi * wave->amplitude_mm / wave->chord_mm);
  }
  return 0;
}

class OutlineBuilder {
 public:
  OutlineBuilder(const Region& region, const Period& period, const PeriodDivision& division)
      : region_(region), period_(period), division_(division), box_(box_of(region.grid, period)) {}

  PeriodOutline build() {
    collect_edges();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      edges_at_[edges_[e].from].push_back(e);
      edges_at_[edges_[e].to].push_back(e);
    }
    is_drawn_.resize(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (is_drawn_[e] == 0 && !goes_on(edges_[e].from)) draw_chain(e, edges_[e].from);
      if (is_drawn_[e] == 0 && !goes_on(edges_[e].to)) draw_chain(e, edges_[e].to);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {  // loops, which have no end
      if (is_drawn_[e] == 0) draw_chain(e, edges_[e].from);
    }
    return std::move(outline_);
  }

 private:
  using Place = std::pair<std::int64_t, std::int32_t>;  // u from the box's left side, z, in steps

  std::uint32_t point(Place place) {
    auto& points = outline_.points;
    const auto [found, is_new] =
        numbers_.try_emplace(place, static_cast<std::uint32_t>(points.size()));
    if (is_new) {
      points.push_back({static_cast<double>(place.first) * region_.grid.u_step_mm,
                        place.second * region_.grid.z_step_mm});
    }
    return found->second;
  }

  bool is_end(std::int32_t z) const { return z == period_.z_from || z == period_.z_to; }
  bool is_inside(std::int32_t low, std::int32_t high) const {
    return low >= period_.z_from && high <= period_.z_to && !(low == high && is_end(low));
  }

  void add_edge(Place a, Place b, Layers left, Layers right, EdgeOrigin origin) {
    BoxEdge edge{point(a), point(b), left, right, std::nullopt};
    edge.curve =
        traced(region_.drawn, origin, outline_.points[edge.from], outline_.points[edge.to]);
    edges_.push_back(edge);
  }

  void collect_edges() {
    for (int sector = 0; sector < period_.sectors; ++sector) {
      const std::int64_t start = std::int64_t{sector} * region_.grid.sector_steps;
      for (const RegionEdge& edge : region_.sectors[static_cast<std::size_t>(sector)]) {
        const auto [low, high] = std::minmax(edge.a.z, edge.b.z);
        if (!is_inside(low, high)) continue;
        add_edge({start + edge.a.u, edge.a.z}, {start + edge.b.u, edge.b.z}, edge.inside_left,
                 edge.inside_right, edge.origin);
      }
    }
    for (int line = 0; line <= period_.sectors; ++line) collect_line(line);
  }

  /// The points on a side of the box; inside of it, the line itself where material ends on it.
  void collect_line(int line) {
    const std::int64_t u = std::int64_t{line} * region_.grid.sector_steps;
    const bool is_side = line == 0 || line == period_.sectors;
    line %= region_.grid.sectors;
    const std::vector<LinePoint> points = line_points(region_, line);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::int32_t low = points[i].z;
      if (is_side && low >= period_.z_from && low <= period_.z_to) point({u, low});
      if (is_side || i + 1 == points.size()) continue;
      const std::int32_t high = points[i + 1].z;
      if (points[i].inside_before == points[i].inside_after || !is_inside(low, high)) continue;
      add_edge({u, low}, {u, high}, points[i].inside_before, points[i].inside_after,
               origin_on_line(region_, line, low, high));
    }
  }

  bool is_on_side(std::uint32_t number) const {
    const PlanePoint& p = outline_.points[number];
    const double step_u = 0.5 * region_.grid.u_step_mm;
    const double step_z = 0.5 * region_.grid.z_step_mm;
    return p.u < step_u || p.u > box_.width_mm - step_u || p.z < box_.z_from_mm + step_z ||
           p.z > box_.z_to_mm - step_z;
  }

  /// Whether a curve runs on through a point.
  bool goes_on(std::uint32_t number) const {
    const std::vector<std::size_t>& here = edges_at_.at(number);
    return here.size() == 2 && !is_on_side(number) &&
           follow_one_curve(edges_[here[0]], edges_[here[1]]);
  }

  void draw_chain(std::size_t first, std::uint32_t start) {
    BoxEdge chain = edges_[first].from == start ? edges_[first] : reversed(edges_[first]);
    double length = distance(outline_.points[chain.from], outline_.points[chain.to]);
    is_drawn_[first] = 1;
    for (std::size_t e = first; goes_on(chain.to) && chain.to != start;) {
      const std::vector<std::size_t>& here = edges_at_.at(chain.to);
      e = here[0] == e ? here[1] : here[0];
      const BoxEdge next = edges_[e].from == chain.to ? edges_[e] : reversed(edges_[e]);
      length += distance(outline_.points[next.from], outline_.points[next.to]);
      chain.to = next.to;
      chain.curve->to = next.curve->to;
      is_drawn_[e] = 1;
    }
    divide(chain, length);
  }

  void divide(const BoxEdge& chain, double length_mm) {
    OutlinePiece whole{.curve = std::nullopt, .left = chain.left, .right = chain.right};
    double count = length_mm / division_.size_mm;
    if (chain.curve) {
      whole.curve = chain.curve->curve;
      whole.from = chain.curve->from;
      whole.to = chain.curve->to;
      whole.offset_mm = chain.curve->turns * region_.drawn.circumference_mm;
      count = std::max(count, turn_rad(*chain.curve) / division_.most_turn_rad);
    }
    const int least = chain.from == chain.to ? 3 : 1;
    const int pieces = std::max(least, static_cast<int>(std::ceil(count - 1e-6)));
    const PlanePoint a = outline_.points[chain.from];
    const PlanePoint b = outline_.points[chain.to];
    std::uint32_t last = chain.from;
    for (int i = 1; i <= pieces; ++i) {
      const double end = static_cast<double>(i) / pieces;
      OutlinePiece piece = whole;
      piece.from = std::lerp(whole.from, whole.to, static_cast<double>(i - 1) / pieces);
      piece.to = std::lerp(whole.from, whole.to, end);
      std::uint32_t next = chain.to;
      if (i < pieces) {
        next = static_cast<std::uint32_t>(outline_.points.size());
        outline_.points.push_back(whole.at(end, a, b));
      }
      outline_.edges.push_back({last, next});
      outline_.pieces.push_back(piece);
      last = next;
    }
  }

  const Region& region_;
  const Period& period_;
  const PeriodDivision& division_;
  PeriodBox box_;
  std::map<Place, std::uint32_t> numbers_;
  std::vector<BoxEdge> edges_;
  std::map<std::uint32_t, std::vector<std::size_t>> edges_at_;
  std::vector<char> is_drawn_;
  PeriodOutline outline_;
};

}  // namespace

PeriodBox box_of(const PlaneGrid& grid, const Period& period) {
  const std::int64_t steps = std::int64_t{period.sectors} * grid.sector_steps;
  return {static_cast<double>(steps) * grid.u_step_mm, period.z_from * grid.z_step_mm,
          period.z_to * grid.z_step_mm};
}

PlanePoint OutlinePiece::at(double t, PlanePoint a, PlanePoint b) const {
  if (!curve) return {std::lerp(a.u, b.u, t), std::lerp(a.z, b.z, t)};
  const PlanePoint p = point_at(curve->shape, std::lerp(from, to, t));
  return {p.u + offset_mm, p.z};
}

PeriodOutline period_outline(const Region& region, const Period& period,
                             const PeriodDivision& division) {
  return OutlineBuilder(region, period, division).build();
}

}  // namespace latticast
