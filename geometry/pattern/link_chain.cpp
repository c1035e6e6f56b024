// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/link_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticast {
namespace {

CurveRange part_of(const CurveRange& range, double from, double to) {
  if (range.curve == own_line) return range;
  return {range.curve, std::lerp(range.from, range.to, from), std::lerp(range.from, range.to, to)};
}

// The polygon's part with 0 <= z <= length (Sutherland-Hodgman against both ends). A part cut off
// in the middle leaves an edge there and back along the end, which encloses nothing.
std::vector<OutlineCorner> clip_ends(std::vector<OutlineCorner> polygon, double length) {
  for (const bool far_end : {false, true}) {
    const double level = far_end ? length : 0;
    const auto inside = [&](const PlanePoint& p) { return far_end ? p.z <= level : p.z >= level; };
    std::vector<OutlineCorner> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto& [a, edge] = polygon[i];
      const PlanePoint& b = polygon[(i + 1) % polygon.size()].point;
      if (inside(a) && inside(b)) kept.push_back(polygon[i]);
      if (inside(a) == inside(b)) continue;
      const double part = (level - a.z) / (b.z - a.z);
      const PlanePoint crossing{std::lerp(a.u, b.u, part), level};
      if (inside(a)) {
        kept.push_back({a, part_of(edge, 0, part)});
        kept.push_back({crossing, {own_line, 0, 1}});
      } else {
        kept.push_back({crossing, part_of(edge, part, 1)});
      }
    }
    polygon = std::move(kept);
  }
  return polygon;
}

double twice_area(const std::vector<OutlineCorner>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& a = polygon[i].point;
    const PlanePoint& b = polygon[(i + 1) % polygon.size()].point;
    sum += a.u * b.z - b.u * a.z;
  }
  return sum;
}

// Counter-clockwise.
Strand strand_of(std::vector<OutlineCorner> polygon, std::vector<DrawnCurve> curves) {
  if (twice_area(polygon) < 0) {
    std::reverse(polygon.begin(), polygon.end());
    const CurveRange last = polygon.front().edge;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CurveRange& edge = i + 1 < polygon.size() ? polygon[i + 1].edge : last;
      polygon[i].edge = part_of(edge, 1, 0);
    }
  }
  Strand strand;
  strand.curves = std::move(curves);
  for (const auto& [point, edge] : polygon) {
    strand.outline.push_back(point);
    strand.traces.push_back(edge);
  }
  return strand;
}

class ChainDrawer {
 public:
  explicit ChainDrawer(const LinkChain& chain) : chain_(chain) {}

  DrawnStrand run() {
    const auto links =
        std::lround(chain_.length_mm / (chain_.frame.along.z * chain_.link_chord_mm));
    const int middle = static_cast<int>(links / 2);
    int first = 0;  // the joint itself lies on the end when there is one link alone
    while (first < chain_.steps && where(middle, first) != Where::inside) ++first;
    const Where up = draw_up(middle, first);
    const Where down = draw_down(middle, first);
    drawn_.in_one_piece = up == Where::above && down == Where::below;
    return std::move(drawn_);
  }

 private:
  enum class Where { below, inside, above };

  // A cross-section less than the flatness inside counts as outside: it would not hold.
  Where where(int link, int step) const {
    const double inner = chain_.edge(link, step, false).z;
    const double outer = chain_.edge(link, step, true).z;
    if (std::max(inner, outer) < chain_.flatness_mm) return Where::below;
    if (std::min(inner, outer) > chain_.length_mm - chain_.flatness_mm) return Where::above;
    return Where::inside;
  }

  Where draw_up(int link, int first) {
    for (;; ++link, first = 0) {
      for (int step = first; step <= chain_.steps; ++step) {
        const Where here = where(link, step);
        if (here == Where::inside) continue;
        add_part(link, first, step);
        return here;
      }
      add_part(link, first, chain_.steps);
      add_corner(link + 1);
    }
  }

  Where draw_down(int link, int last) {
    for (;; --link, last = chain_.steps) {
      for (int step = last; step >= 0; --step) {
        const Where here = where(link, step);
        if (here == Where::inside) continue;
        add_part(link, step, last);
        return here;
      }
      add_part(link, 0, last);
      add_corner(link);
    }
  }

  DrawnCurve cut(int link, int step) const {
    return {.shape = StraightLine{chain_.edge(link, step, true), chain_.edge(link, step, false)},
            .part = CurvePart::strand,
            .link = link};
  }

  void add_part(int link, int from, int to) {
    if (from == to) return;
    const auto part = [&](int step) { return static_cast<double>(step) / chain_.steps; };
    TracedOutline traced{
        {}, {chain_.side(link, true), cut(link, to), chain_.side(link, false), cut(link, from)}};
    std::vector<OutlineCorner>& outline = traced.corners;
    for (int step = from; step < to; ++step) {
      outline.push_back({chain_.edge(link, step, true), {0, part(step), part(step + 1)}});
    }
    outline.push_back({chain_.edge(link, to, true), {1, 0, 1}});
    for (int step = to; step > from; --step) {
      outline.push_back({chain_.edge(link, step, false), {2, part(step), part(step - 1)}});
    }
    outline.push_back({chain_.edge(link, from, false), {3, 1, 0}});
    add(std::move(traced));
  }

  void add_corner(int joint) {
    if (chain_.corner) add(chain_.corner(joint));
  }

  void add(TracedOutline traced) {
    std::vector<OutlineCorner> outline = clip_ends(std::move(traced.corners), chain_.length_mm);
    if (outline.size() < 3) return;
    drawn_.links.push_back(strand_of(std::move(outline), std::move(traced.curves)));
  }

  const LinkChain& chain_;
  DrawnStrand drawn_;
};

}  // namespace

DrawnStrand draw_chain(const LinkChain& chain) {
  return ChainDrawer(chain).run();
}

}  // namespace latticast
