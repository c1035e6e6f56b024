// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/horseshoe_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "design/units.h"
#include "geometry/pattern/link_chain.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr double widest_arc_step = 0.5;  // in radians; the error of chords is a series in the step
constexpr int samples_per_arc = 256;
constexpr double worst_sag = 1.05;

double half_arc(const Horseshoe& shape) {
  return 0.5 * radians(shape.arc_deg);
}

int side_of_arc(const Horseshoe& shape, int arc) {
  return shape.alternate && arc % 2 != 0 ? -1 : 1;
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
    return step > widest_arc_step ? HUGE_VAL : radius * (outward_factor(step, steps) - 1);
  };
  int steps = std::max(2, static_cast<int>(arc / std::sqrt(12 * flatness / radius)));
  while (off(steps) > flatness) ++steps;
  return steps;
}

// A flattened column.
class Arcs {
 public:
  Arcs(const HorseshoeColumn& column, double flatness)
      : column_(column),
        flatness_(flatness),
        frame_(strand_frame(column.start_u_mm, column.angle_deg)),
        radius_(closing_radius_mm(column)),
        half_(half_arc(column.shape)),
        chord_(2 * radius_ * std::sin(half_)),
        steps_(flat_steps(radius_ + 0.5 * column.width_mm, 2 * half_, flatness)),
        outward_(outward_factor(2 * half_ / steps_, steps_)) {}

  DrawnStrand draw() const {
    LinkChain chain{
        .frame = frame_,
        .link_chord_mm = chord_,
        .length_mm = column_.length_mm,
        .flatness_mm = flatness_,
        .steps = steps_,
        .edge = [this](int arc, int step, bool outer) { return edge(arc, step, outer); },
        .side = [this](int arc, bool outer) { return side(arc, outer); },
        .corner = {}};
    if (!column_.shape.alternate) chain.corner = [this](int joint) { return disc(joint); };
    DrawnStrand drawn = draw_chain(chain);
    drawn.error = error(drawn.links.size());
    return drawn;
  }

 private:
  // Both ends of a joint are the same for both its arcs.
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

  // Directions count from the arc's middle, along the strand.
  DrawnCurve side(int arc, bool outer) const {
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

  // Arcs that all bulge to one side meet at an angle.
  TracedOutline disc(int joint) const {
    const double radius = 0.5 * column_.width_mm;
    const int steps = flat_steps(radius, 2 * std::numbers::pi, flatness_);
    const double step = 2 * std::numbers::pi / steps;
    const double outward = std::sqrt(step / std::sin(step));
    const double start = radians(column_.angle_deg);
    TracedOutline disc{{},
                       {{.shape = CircularArc{.centre = frame_.at(joint * chord_, 0),
                                              .radius_mm = radius,
                                              .from_rad = start,
                                              .to_rad = start - 2 * std::numbers::pi},
                         .part = CurvePart::joint,
                         .link = joint}}};
    const auto part = [&](int i) { return static_cast<double>(i) / steps; };
    disc.corners.reserve(steps);
    for (int i = 0; i < steps; ++i) {
      disc.corners.push_back({frame_.at(joint * chord_ + outward * radius * std::cos(i * step),
                                        outward * radius * std::sin(i * step)),
                              {0, part(i), part(i + 1)}});
    }
    return disc;
  }

  // The chords at an arc's ends, between the circle and the points further out, sag the most: by
  // 1.042 of what those points are out by. Whole arcs keep their area; where an end or another
  // strand cuts one, up to half a chord's share is left over on either side.
  DrawingError error(std::size_t polygons) const {
    const double radius = radius_ + 0.5 * column_.width_mm;
    const double off = worst_sag * radius * (outward_ - 1);
    const double chord = radius * 2 * half_ / steps_;
    // Discs at joints have chords of their own.
    return {column_.shape.alternate ? off : std::max(off, flatness_),
            static_cast<double>(polygons) * off * chord};
  }

  const HorseshoeColumn& column_;
  double flatness_;
  StrandFrame frame_;
  double radius_;
  double half_;
  double chord_;
  int steps_;
  double outward_;
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
double centre_line_distance_mm(const HorseshoeColumn& column, double along_mm, double across_mm) {
  const Horseshoe& shape = column.shape;
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
  const StrandFrame frame = strand_frame(0, column.angle_deg);
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
      closest = std::min(closest, centre_line_distance_mm(column, other_s, other_t));
    }
  }
  return closest;
}

DrawnStrand draw_strand(const HorseshoeColumn& column, double flatness_mm) {
  return Arcs(column, flatness_mm).draw();
}

double link_chord_mm(const HorseshoeColumn& column) {
  return chord_mm(column.shape);
}

double link_length_mm(const HorseshoeColumn& column) {
  return 2 * column.shape.radius_mm * half_arc(column.shape);
}

double largest_slope_deg(const HorseshoeColumn& column) {
  return 0.5 * column.shape.arc_deg;
}

double reach_mm(const HorseshoeColumn& column) {
  return column.shape.radius_mm * (1 - std::cos(half_arc(column.shape)));
}

double smallest_radius_mm(const HorseshoeColumn& column) {
  return column.shape.radius_mm;
}

HorseshoeColumn closed(HorseshoeColumn column) {
  column.shape.radius_mm = closing_radius_mm(column);
  return column;
}

Horseshoe stretched(const HorseshoeColumn& column, double stretch) {
  const Horseshoe& rest = column.shape;
  const double half = half_arc(rest);
  const double ratio = std::min(0.999, stretch * std::sin(half) / half);  // chord over arc
  const auto excess = [&](double angle) { return std::sin(angle) / angle - ratio; };
  const double now = bracketed_root(excess, 0, 1 - ratio, std::numbers::pi, -ratio, 0);
  Horseshoe arc = rest;
  arc.radius_mm = rest.radius_mm * half / now;
  arc.arc_deg = degrees(2 * now);
  return arc;
}

double gap_within_mm(const HorseshoeColumn& column) {
  const Horseshoe& arc = column.shape;
  const double across = 2 * arc.radius_mm;
  const double inside = across - column.width_mm;
  if (arc.arc_deg <= 180) return inside;
  const double apart =
      arc.alternate ? 2 * chord_mm(arc) - across - column.width_mm : chord_mm(arc) - across;
  return std::min(inside, apart);
}

}  // namespace latticast
