// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/horseshoe_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace latticast {
namespace {

constexpr double closing_tolerance = 2e-3;  // relative change of the radius that goes unsaid
constexpr double radians = std::numbers::pi / 180;

double half_arc(const Horseshoe& shape) {
  return 0.5 * shape.arc_deg * radians;
}

// Where the column's arcs are drawn: along its chord line and to the right of it.
struct Frame {
  PlanePoint origin;
  PlanePoint along;
  PlanePoint right;

  PlanePoint at(double s, double t) const {
    return {origin.u + s * along.u + t * right.u, origin.z + s * along.z + t * right.z};
  }
};

Frame frame_of(const HorseshoeColumn& column) {
  const double angle = column.angle_deg * radians;
  const double cosine = column.angle_deg == 90 ? 0.0 : std::cos(angle);
  return {{column.start_u_mm, 0}, {cosine, std::sin(angle)}, {std::sin(angle), -cosine}};
}

// Points of a flattened arc about (s, t), from direction -half to +half seen from the chord's
// normal. Inner points lie further out than the end points, so that the polygon has the sector's
// area.
std::vector<PlanePoint> flat_arc(double s, double t, double radius, double half, int steps,
                                 int side) {
  const double step = 2 * half / steps;
  const double needed = steps * step / std::sin(step);
  const double outward =
      steps == 2 ? 0.5 * needed : (std::sqrt(1 + (steps - 2) * needed) - 1) / (steps - 2);
  std::vector<PlanePoint> points;
  for (int i = 0; i <= steps; ++i) {
    const double direction = -half + i * step;
    const double r = i == 0 || i == steps ? radius : radius * outward;
    points.push_back({s + r * std::sin(direction), t + side * r * std::cos(direction)});
  }
  return points;
}

int flat_steps(double radius, double arc, double flatness) {
  // As for the columns around the tube, chords of equal area stay within r D^2/12 of the circle.
  const double step = std::min(0.5, std::sqrt(12 * flatness / radius));
  return std::max(2, static_cast<int>(std::ceil(arc / step)));
}

// The polygon's part with 0 <= z <= length (Sutherland-Hodgman against both ends). A part cut off
// in the middle leaves an edge there and back along the end, which encloses nothing.
std::vector<PlanePoint> clip_ends(std::vector<PlanePoint> polygon, double length) {
  for (const bool far_end : {false, true}) {
    const double level = far_end ? length : 0;
    const auto inside = [&](const PlanePoint& p) { return far_end ? p.z <= level : p.z >= level; };
    std::vector<PlanePoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PlanePoint& a = polygon[i];
      const PlanePoint& b = polygon[(i + 1) % polygon.size()];
      if (inside(a)) kept.push_back(a);
      if (inside(a) == inside(b)) continue;
      kept.push_back({std::lerp(a.u, b.u, (level - a.z) / (b.z - a.z)), level});
    }
    polygon = std::move(kept);
  }
  return polygon;
}

void make_counter_clockwise(std::vector<PlanePoint>& polygon) {
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& a = polygon[i];
    const PlanePoint& b = polygon[(i + 1) % polygon.size()];
    twice_area += a.u * b.z - b.u * a.z;
  }
  if (twice_area < 0) std::reverse(polygon.begin(), polygon.end());
}

class Drawer {
 public:
  Drawer(const HorseshoeColumn& column, double flatness)
      : column_(column),
        frame_(frame_of(column)),
        radius_(closing_radius_mm(column)),
        half_(half_arc(column.shape)),
        steps_(flat_steps(radius_ + 0.5 * column.width_mm, 2 * half_, flatness)) {}

  // One arc more than the segment holds at either end: what lies beyond the ends is cut off.
  std::vector<Strand> run() {
    const double chord = 2 * radius_ * std::sin(half_);
    const double reach = radius_ + column_.width_mm;
    const double along = frame_.along.z * chord;
    const int extra = 1 + static_cast<int>(std::ceil(reach / along));
    const int arcs = static_cast<int>(std::lround(column_.length_mm / along));
    for (int i = -extra; i < arcs + extra; ++i) {
      const int side = column_.shape.alternate && i % 2 != 0 ? -1 : 1;
      add_arc((i + 0.5) * chord, side);
      if (!column_.shape.alternate) add_joint(i * chord);
    }
    return std::move(strands_);
  }

 private:
  void add_arc(double middle, int side) {
    const double centre = -side * radius_ * std::cos(half_);
    const double half_width = 0.5 * column_.width_mm;
    std::vector<PlanePoint> outline =
        flat_arc(middle, centre, radius_ + half_width, half_, steps_, side);
    std::vector<PlanePoint> inner =
        flat_arc(middle, centre, radius_ - half_width, half_, steps_, side);
    outline.insert(outline.end(), inner.rbegin(), inner.rend());
    add(std::move(outline));
  }

  // Arcs that all bulge to one side meet at an angle; a disc rounds the joint.
  void add_joint(double s) {
    const double radius = 0.5 * column_.width_mm;
    std::vector<PlanePoint> disc;
    for (int i = 0; i < 24; ++i) {
      const double direction = 2 * std::numbers::pi * i / 24;
      disc.push_back({s + radius * std::cos(direction), radius * std::sin(direction)});
    }
    add(std::move(disc));
  }

  void add(std::vector<PlanePoint> outline) {
    for (PlanePoint& point : outline) point = frame_.at(point.u, point.z);
    outline = clip_ends(std::move(outline), column_.length_mm);
    if (outline.size() < 3) return;
    make_counter_clockwise(outline);
    strands_.push_back({std::move(outline)});
  }

  const HorseshoeColumn& column_;
  Frame frame_;
  double radius_;
  double half_;
  int steps_;
  std::vector<Strand> strands_;
};

// The centre line over two arcs, in the plane, for distances between neighbours.
std::vector<PlanePoint> sampled_centre_line(const HorseshoeColumn& column) {
  constexpr int samples = 200;
  const Frame frame = frame_of(column);
  const double radius = column.shape.radius_mm;
  const double half = half_arc(column.shape);
  const double chord = chord_mm(column.shape);
  std::vector<PlanePoint> points;
  for (int arc = -2; arc < 4; ++arc) {
    const int side = column.shape.alternate && arc % 2 != 0 ? -1 : 1;
    for (int i = 0; i < samples; ++i) {
      const double direction = -half + 2 * half * i / samples;
      points.push_back(frame.at((arc + 0.5) * chord + radius * std::sin(direction),
                                side * radius * (std::cos(direction) - std::cos(half))));
    }
  }
  return points;
}

}  // namespace

double chord_mm(const Horseshoe& shape) {
  return 2 * shape.radius_mm * std::sin(half_arc(shape));
}

double arcs_on_segment(const HorseshoeColumn& column) {
  return column.length_mm / (chord_mm(column.shape) * std::sin(column.angle_deg * radians));
}

double closing_radius_mm(const HorseshoeColumn& column) {
  const double arcs = arcs_on_segment(column);
  return column.shape.radius_mm * arcs / std::max(1.0, std::round(arcs));
}

std::vector<std::string> drawing_problems(const HorseshoeColumn& column) {
  std::vector<std::string> problems;
  const double radius = column.shape.radius_mm;
  const double closing = closing_radius_mm(column);
  if (std::abs(closing - radius) > closing_tolerance * radius) {
    problems.push_back(
        fmt::format("{:.2f} arcs of radius {:g} mm fill the segment, not a whole number; radius "
                    "{:.6g} mm closes it with {:g}",
                    arcs_on_segment(column), radius, closing,
                    std::max(1.0, std::round(arcs_on_segment(column)))));
  }
  if (column.width_mm >= 2 * radius) {
    problems.push_back(
        fmt::format("the strand is {:g} mm wide, wider than its arcs' diameter, and folds over "
                    "itself; a radius above {:.6g} mm avoids it",
                    column.width_mm, 0.5 * column.width_mm));
  }
  const double half = half_arc(column.shape);
  const bool one_sided_overlap = !column.shape.alternate && half > 0.5 * std::numbers::pi;
  const bool alternate_overlap = column.shape.alternate &&
                                 4 * radius * std::sin(half) <= 2 * radius + column.width_mm &&
                                 half > 0.5 * std::numbers::pi;
  if (one_sided_overlap) {
    problems.push_back(
        fmt::format("arcs of {:g} degrees on one side run into each other; 180 degrees is the most",
                    column.shape.arc_deg));
  } else if (alternate_overlap) {
    const double sine = std::min(1.0, 0.5 + 0.25 * column.width_mm / radius);
    problems.push_back(fmt::format(
        "every second arc of {:g} degrees runs into the next; below {:.4g} degrees they "
        "stay apart",
        column.shape.arc_deg, 2 * (std::numbers::pi - std::asin(sine)) / radians));
  }
  return problems;
}

double clearance_mm(const HorseshoeColumn& column, double spacing_u_mm, double neighbour_width_mm) {
  const std::vector<PlanePoint> line = sampled_centre_line(column);
  double closest = HUGE_VAL;
  for (std::size_t i = line.size() / 3; i < 2 * line.size() / 3; ++i) {
    for (const PlanePoint& other : line) {
      closest =
          std::min(closest, std::hypot(other.u + spacing_u_mm - line[i].u, other.z - line[i].z));
    }
  }
  return closest - 0.5 * (column.width_mm + neighbour_width_mm);
}

int most_columns(const HorseshoeColumn& column, double circumference_mm,
                 double neighbour_width_mm) {
  int low = 1;  // leaves a gap, or is the least there can be
  int high = std::max(2, static_cast<int>(circumference_mm / column.width_mm) + 1);  // leaves none
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    const bool gap = clearance_mm(column, circumference_mm / middle, neighbour_width_mm) > 0;
    (gap ? low : high) = middle;
  }
  return low;
}

std::vector<Strand> draw_horseshoe(const HorseshoeColumn& column, double flatness_mm) {
  return Drawer(column, flatness_mm).run();
}

}  // namespace latticast
