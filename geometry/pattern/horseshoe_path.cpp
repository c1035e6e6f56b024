// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/horseshoe_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "design/units.h"

namespace latticast {
namespace {

constexpr double widest_step = 0.5;  // in radians; the error of chords is a series in the step
constexpr int samples_per_arc = 256;
constexpr double worst_sag = 1.05;

double half_arc(const Horseshoe& shape) {
  return 0.5 * radians(shape.arc_deg);
}

int side_of_arc(const Horseshoe& shape, int arc) {
  return shape.alternate && arc % 2 != 0 ? -1 : 1;
}

// Where the column's arcs are drawn: s along its chord line, t to the right of it.
struct Frame {
  PlanePoint origin;
  PlanePoint along;
  PlanePoint right;

  PlanePoint at(double s, double t) const {
    return {origin.u + s * along.u + t * right.u, origin.z + s * along.z + t * right.z};
  }
};

Frame frame_of(const HorseshoeColumn& column) {
  const double angle = radians(column.angle_deg);
  const double cosine = column.angle_deg == 90 ? 0.0 : std::cos(angle);
  return {{column.start_u_mm, 0}, {cosine, std::sin(angle)}, {std::sin(angle), -cosine}};
}

// Inner points of a flattened arc lie further out than its end points, so that the polygon has the
// sector's area: n - 2 triangles between inner points and two with an end point.
double outward_factor(double step, int steps) {
  const double needed = steps * step / std::sin(step);
  return steps == 2 ? 0.5 * needed : (std::sqrt(1 + (steps - 2) * needed) - 1) / (steps - 2);
}

int flat_steps(double radius, double arc, double flatness) {
  const auto off = [&](int steps) {
    const double step = arc / steps;
    return step > widest_step ? HUGE_VAL : radius * (outward_factor(step, steps) - 1);
  };
  int steps = std::max(2, static_cast<int>(arc / std::sqrt(12 * flatness / radius)));
  while (off(steps) > flatness) ++steps;
  return steps;
}

// A corner of a polygon, and what the edge from it to the next one stands for.
struct Corner {
  PlanePoint point;
  CurveRange edge;
};

CurveRange part_of(const CurveRange& range, double from, double to) {
  return {range.curve, std::lerp(range.from, range.to, from), std::lerp(range.from, range.to, to)};
}

// The polygon's part with 0 <= z <= length (Sutherland-Hodgman against both ends). A part cut off
// in the middle leaves an edge there and back along the end, which encloses nothing.
std::vector<Corner> clip_ends(std::vector<Corner> polygon, double length) {
  for (const bool far_end : {false, true}) {
    const double level = far_end ? length : 0;
    const auto inside = [&](const PlanePoint& p) { return far_end ? p.z <= level : p.z >= level; };
    std::vector<Corner> kept;
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

double twice_area(const std::vector<Corner>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& a = polygon[i].point;
    const PlanePoint& b = polygon[(i + 1) % polygon.size()].point;
    sum += a.u * b.z - b.u * a.z;
  }
  return sum;
}

// Counter-clockwise.
Strand strand_of(std::vector<Corner> polygon, std::vector<DrawnCurve> curves) {
  if (twice_area(polygon) < 0) {
    std::reverse(polygon.begin(), polygon.end());
    const CurveRange last = polygon.front().edge;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CurveRange& edge = i + 1 < polygon.size() ? polygon[i + 1].edge : last;
      polygon[i].edge = {edge.curve, edge.to, edge.from};
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

class Drawer {
 public:
  Drawer(const HorseshoeColumn& column, double flatness)
      : column_(column),
        flatness_(flatness),
        frame_(frame_of(column)),
        radius_(closing_radius_mm(column)),
        half_(half_arc(column.shape)),
        chord_(2 * radius_ * std::sin(half_)),
        steps_(flat_steps(radius_ + 0.5 * column.width_mm, 2 * half_, flatness)),
        outward_(outward_factor(2 * half_ / steps_, steps_)) {}

  // From the middle of the strand to both ends: what lies beyond its first way out is loose.
  DrawnHorseshoe run() {
    const auto arcs = std::lround(column_.length_mm / (frame_.along.z * chord_));
    const int middle = static_cast<int>(arcs / 2);
    int first = 0;  // the joint itself lies on the end when there is one arc alone
    while (first < steps_ && where(middle, first) != Where::inside) ++first;
    const Where up = draw_up(middle, first);
    const Where down = draw_down(middle, first);
    drawn_.in_one_piece = up == Where::above && down == Where::below;
    drawn_.error = error();
    return std::move(drawn_);
  }

 private:
  enum class Where { below, inside, above };

  // One end of a cross-section of the strand; both ends of a joint are the same for both its arcs.
  PlanePoint edge(int arc, int step, bool outer) const {
    const int side = side_of_arc(column_.shape, arc);
    const double direction = -half_ + step * (2 * half_ / steps_);
    const double half_width = outer ? 0.5 * column_.width_mm : -0.5 * column_.width_mm;
    if (step == 0 || step == steps_) {
      const double across = std::copysign(std::sin(half_), direction);
      return frame_.at((arc + (step == 0 ? 0 : 1)) * chord_ + half_width * across,
                       half_width * side * std::cos(half_));
    }
    const double r = outward_ * (radius_ + half_width);
    return frame_.at((arc + 0.5) * chord_ + r * std::sin(direction),
                     side * (r * std::cos(direction) - radius_ * std::cos(half_)));
  }

  // A cross-section less than the flatness inside counts as outside: it would not hold.
  Where where(int arc, int step) const {
    const double inner = edge(arc, step, false).z;
    const double outer = edge(arc, step, true).z;
    if (std::max(inner, outer) < flatness_) return Where::below;
    if (std::min(inner, outer) > column_.length_mm - flatness_) return Where::above;
    return Where::inside;
  }

  Where draw_up(int arc, int first) {
    for (;; ++arc, first = 0) {
      for (int step = first; step <= steps_; ++step) {
        const Where here = where(arc, step);
        if (here == Where::inside) continue;
        add_sector(arc, first, step);
        return here;
      }
      add_sector(arc, first, steps_);
      add_joint(arc + 1);
    }
  }

  Where draw_down(int arc, int last) {
    for (;; --arc, last = steps_) {
      for (int step = last; step >= 0; --step) {
        const Where here = where(arc, step);
        if (here == Where::inside) continue;
        add_sector(arc, step, last);
        return here;
      }
      add_sector(arc, 0, last);
      add_joint(arc);
    }
  }

  // The side of a whole arc. Directions count from the arc's middle, along the strand.
  DrawnCurve side_curve(int arc, bool outer) const {
    const int bulge = side_of_arc(column_.shape, arc);
    const double half_width = outer ? 0.5 * column_.width_mm : -0.5 * column_.width_mm;
    const double middle = radians(column_.angle_deg) - bulge * 0.5 * std::numbers::pi;
    return {.shape = CircularArc{.centre = frame_.at((arc + 0.5) * chord_,
                                                     -bulge * radius_ * std::cos(half_)),
                                 .radius_mm = radius_ + half_width,
                                 .from_rad = middle - bulge * half_,
                                 .to_rad = middle + bulge * half_},
            .part = CurvePart::strand,
            .link = arc,
            .side = outer ? bulge : -bulge};
  }

  DrawnCurve cut_curve(int arc, int step) const {
    return {.shape = StraightLine{edge(arc, step, true), edge(arc, step, false)},
            .part = CurvePart::strand,
            .link = arc};
  }

  void add_sector(int arc, int from, int to) {
    if (from == to) return;
    const auto part = [&](int step) { return static_cast<double>(step) / steps_; };
    std::vector<Corner> outline;
    for (int step = from; step < to; ++step) {
      outline.push_back({edge(arc, step, true), {0, part(step), part(step + 1)}});
    }
    outline.push_back({edge(arc, to, true), {1, 0, 1}});
    for (int step = to; step > from; --step) {
      outline.push_back({edge(arc, step, false), {2, part(step), part(step - 1)}});
    }
    outline.push_back({edge(arc, from, false), {3, 1, 0}});
    add(std::move(outline),
        {side_curve(arc, true), cut_curve(arc, to), side_curve(arc, false), cut_curve(arc, from)});
  }

  // Arcs that all bulge to one side meet at an angle.
  void add_joint(int joint) {
    if (column_.shape.alternate) return;
    const double radius = 0.5 * column_.width_mm;
    const int steps = flat_steps(radius, 2 * std::numbers::pi, flatness_);
    const double step = 2 * std::numbers::pi / steps;
    const double outward = std::sqrt(step / std::sin(step));
    const auto part = [&](int i) { return static_cast<double>(i) / steps; };
    std::vector<Corner> disc;
    disc.reserve(steps);
    for (int i = 0; i < steps; ++i) {
      disc.push_back({frame_.at(joint * chord_ + outward * radius * std::cos(i * step),
                                outward * radius * std::sin(i * step)),
                      {0, part(i), part(i + 1)}});
    }
    const double start = radians(column_.angle_deg);
    add(std::move(disc), {{.shape = CircularArc{.centre = frame_.at(joint * chord_, 0),
                                                .radius_mm = radius,
                                                .from_rad = start,
                                                .to_rad = start - 2 * std::numbers::pi},
                           .part = CurvePart::joint,
                           .link = joint}});
  }

  // The chords at an arc's ends, between the circle and the points further out, sag the most: by
  // 1.042 of what those points are out by. Whole arcs keep their area; where an end or another
  // strand cuts one, up to half a chord's share is left over on either side.
  DrawingError error() const {
    const double radius = radius_ + 0.5 * column_.width_mm;
    const double off = worst_sag * radius * (outward_ - 1);
    const double chord = radius * 2 * half_ / steps_;
    // Discs at joints have chords of their own.
    return {column_.shape.alternate ? off : std::max(off, flatness_),
            static_cast<double>(drawn_.arcs.size()) * off * chord};
  }

  void add(std::vector<Corner> outline, std::vector<DrawnCurve> curves) {
    outline = clip_ends(std::move(outline), column_.length_mm);
    if (outline.size() < 3) return;
    drawn_.arcs.push_back(strand_of(std::move(outline), std::move(curves)));
  }

  const HorseshoeColumn& column_;
  double flatness_;
  Frame frame_;
  double radius_;
  double half_;
  double chord_;
  int steps_;
  double outward_;
  DrawnHorseshoe drawn_;
};

// Distance of a point, given along and across the chord line, from one arc's centre line.
double distance_to_arc(const Horseshoe& shape, int arc, double s, double t) {
  const double chord = chord_mm(shape);
  const double cosine = std::cos(half_arc(shape));
  const double from_middle = s - (arc + 0.5) * chord;
  const double outward = side_of_arc(shape, arc) * t + shape.radius_mm * cosine;
  const double r = std::hypot(from_middle, outward);
  if (outward >= r * cosine) return std::abs(r - shape.radius_mm);
  return std::hypot(std::abs(from_middle) - 0.5 * chord, t);
}

}  // namespace

double chord_mm(const Horseshoe& shape) {
  return 2 * shape.radius_mm * std::sin(half_arc(shape));
}

double arcs_on_segment(const HorseshoeColumn& column) {
  return column.length_mm / (chord_mm(column.shape) * std::sin(radians(column.angle_deg)));
}

double closing_radius_mm(const HorseshoeColumn& column) {
  const double arcs = arcs_on_segment(column);
  return column.shape.radius_mm * arcs / std::max(1.0, std::round(arcs));
}

// A strand is narrower than 2 R, and an arc reaches no further than R from its middle.
double centre_line_distance_mm(const Horseshoe& shape, double along_mm, double across_mm) {
  const double chord = chord_mm(shape);
  const int reach = 1 + static_cast<int>(std::ceil(3 * shape.radius_mm / chord));
  const int nearest = static_cast<int>(std::floor(along_mm / chord));
  double closest = HUGE_VAL;
  for (int arc = nearest - reach; arc <= nearest + reach; ++arc) {
    closest = std::min(closest, distance_to_arc(shape, arc, along_mm, across_mm));
  }
  return closest;
}

double centre_distance_mm(const HorseshoeColumn& column, double spacing_u_mm) {
  const Horseshoe& shape = column.shape;
  const Frame frame = frame_of(column);
  const double half = half_arc(shape);
  const double chord = chord_mm(shape);
  const double radius = shape.radius_mm;
  double closest = HUGE_VAL;
  for (int arc = 0; arc < (shape.alternate ? 2 : 1); ++arc) {
    const int side = side_of_arc(shape, arc);
    for (int i = 0; i < samples_per_arc; ++i) {
      const double direction = -half + 2 * half * i / samples_per_arc;
      const double s = (arc + 0.5) * chord + radius * std::sin(direction);
      const double t = side * radius * (std::cos(direction) - std::cos(half));
      const double other_s = s - spacing_u_mm * frame.along.u;
      const double other_t = t - spacing_u_mm * frame.right.u;
      closest = std::min(closest, centre_line_distance_mm(shape, other_s, other_t));
    }
  }
  return closest;
}

DrawnHorseshoe draw_horseshoe(const HorseshoeColumn& column, double flatness_mm) {
  return Drawer(column, flatness_mm).run();
}

}  // namespace latticast
