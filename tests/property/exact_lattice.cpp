// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/property/exact_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "design/units.h"
#include "geometry/pattern/rings.h"

namespace latticast {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);
constexpr double fine_angle = 1e-3;  // in which arcs are followed to the segment's ends

struct Vector {
  double u = 0;
  double z = 0;
  friend Vector operator+(Vector a, Vector b) { return {a.u + b.u, a.z + b.z}; }
  friend Vector operator-(Vector a, Vector b) { return {a.u - b.u, a.z - b.z}; }
  friend Vector operator*(double s, Vector a) { return {s * a.u, s * a.z}; }
  double length() const { return std::hypot(u, z); }
};

double dot(Vector a, Vector b) {
  return a.u * b.u + a.z * b.z;
}

// Neighbouring arcs meet in a cross-section, which belongs to both.
bool between_angles(double angle, double from, double to) {
  constexpr double slack = 1e-9;
  const double beyond = angle - from + slack;
  return beyond - 2 * pi * std::floor(beyond / (2 * pi)) <= to - from + 2 * slack;
}

// Straight line through a point, or a circle.
struct Curve {
  Vector at;
  Vector direction;
  double radius = 0;  // 0: straight
};

Vector foot_of_origin(const Curve& curve) {
  if (curve.radius > 0) {
    const double far = curve.at.length();
    return (1 - curve.radius / far) * curve.at;
  }
  return curve.at - dot(curve.at, curve.direction) * curve.direction;
}

void add_line_circle(const Curve& line, const Curve& circle, std::vector<Vector>& points) {
  const Vector to = circle.at - line.at;
  const double along = dot(to, line.direction);
  const Vector foot = line.at + along * line.direction;
  const double off = (circle.at - foot).length();
  if (off > circle.radius) return;
  const double half = std::sqrt(circle.radius * circle.radius - off * off);
  points.push_back(foot + half * line.direction);
  points.push_back(foot - half * line.direction);
}

void add_circles(const Curve& a, const Curve& b, std::vector<Vector>& points) {
  const Vector to = b.at - a.at;
  const double apart = to.length();
  const double slack = 1e-9 * (a.radius + b.radius);  // touching counts
  if (apart == 0 || apart > a.radius + b.radius + slack) return;
  if (apart < std::abs(a.radius - b.radius) - slack) return;
  const double along = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vector unit = (1 / apart) * to;
  const Vector foot = a.at + along * unit;
  points.push_back(foot + half * Vector{-unit.z, unit.u});
  points.push_back(foot - half * Vector{-unit.z, unit.u});
}

void add_meetings(const Curve& a, const Curve& b, std::vector<Vector>& points) {
  if (a.radius > 0 && b.radius > 0) return add_circles(a, b, points);
  if (a.radius > 0) return add_line_circle(b, a, points);
  if (b.radius > 0) return add_line_circle(a, b, points);
  const double sine = a.direction.u * b.direction.z - a.direction.z * b.direction.u;
  if (std::abs(sine) < 1e-12) return;
  const Vector to = b.at - a.at;
  const double along = (to.u * b.direction.z - to.z * b.direction.u) / sine;
  points.push_back(a.at + along * a.direction);
}

Depth toward_segment(Vector place, Vector a, Vector b) {
  const Vector along = b - a;
  const double part = std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0);
  const Vector off = a + part * along - place;
  const double far = off.length();
  if (far == 0) return {0, 0, 1};
  return {-far, off.u / far, off.z / far};
}

}  // namespace

ExactLattice::ExactLattice(const Segment& segment)
    : circumference_(2 * pi * segment.lattice_mid_radius_mm()),
      length_(segment.length_mm),
      fillet_(segment.lattice->fillet_mm) {
  const Lattice& lattice = *segment.lattice;
  if (lattice.rings) {
    const double half = 0.5 * lattice.rings->width_mm;
    for (const double centre : ring_centres_mm(*lattice.rings, length_)) {
      rings_.push_back({std::max(0.0, centre - half), std::min(length_, centre + half)});
    }
  }
  for (const Grid& grid : lattice.grids) {
    for (int i = 0; i < grid.count(); ++i) {
      if (!is_curved(grid.path)) add_strip(grid, i);
    }
  }
  for (const Grid& grid : lattice.grids) {
    for (int i = 0; i < grid.count(); ++i) {
      if (is_curved(grid.path)) add_horseshoes(grid, i);
    }
  }
  add_sides();
  add_ends();
}

void ExactLattice::add_strip(const Grid& grid, int strand) {
  const double angle = grid.angle_rad();
  const double cotangent = grid.angle_deg == 90 ? 0 : std::cos(angle) / std::sin(angle);
  strips_.push_back({strand * circumference_ / grid.count(), cotangent,
                     0.5 * grid.widths_mm[strand] / std::sin(angle)});
}

// Arcs from the middle of the strand to its first way out, at either end.
void ExactLattice::add_horseshoes(const Grid& grid, int strand) {
  const double angle = grid.angle_rad();
  const double half = 0.5 * radians(std::get<Horseshoe>(grid.path).arc_deg);
  const double asked =
      2 * std::get<Horseshoe>(grid.path).radius_mm * std::sin(half) * std::sin(angle);
  const double count = std::max(1.0, std::round(length_ / asked));
  const double radius = length_ / count / (2 * std::sin(half) * std::sin(angle));
  const double chord = 2 * radius * std::sin(half);
  const double width = grid.widths_mm[strand];
  const Vector along{std::cos(angle), std::sin(angle)};
  const Vector right{std::sin(angle), -std::cos(angle)};
  const Vector start{strand * circumference_ / grid.count(), 0};
  const auto side_of = [&](int arc) {
    return std::get<Horseshoe>(grid.path).alternate && arc % 2 != 0 ? -1 : 1;
  };
  const auto centre_of = [&](int arc) {
    return start + (arc + 0.5) * chord * along - side_of(arc) * radius * std::cos(half) * right;
  };
  const auto is_out = [&](int arc, double turn, bool up) {
    const Vector radial = std::sin(turn) * along + side_of(arc) * std::cos(turn) * right;
    const Vector centre = centre_of(arc);
    const double a = centre.z + (radius - 0.5 * width) * radial.z;
    const double b = centre.z + (radius + 0.5 * width) * radial.z;
    return up ? std::min(a, b) > length_ : std::max(a, b) < 0;
  };
  const auto add = [&](int arc, double from, double to) {
    const Vector c = centre_of(arc);
    const double zero = angle - side_of(arc) * 0.5 * pi;
    const double first = side_of(arc) > 0 ? zero + from : zero - to;
    arcs_.push_back(
        {c.u, c.z, radius - 0.5 * width, radius + 0.5 * width, first, first + (to - from)});
    if (std::get<Horseshoe>(grid.path).alternate || to < half) return;  // joined to no next arc
    const Vector joint = start + (arc + 1) * chord * along;
    arcs_.push_back({joint.u, joint.z, 0, 0.5 * width, 0, 2 * pi});
  };
  const auto follow = [&](bool up) {
    const int middle = static_cast<int>(count) / 2;
    for (int arc = up ? middle : middle - 1;; arc += up ? 1 : -1) {
      double turn = up ? -half : half;
      while (std::abs(turn) <= half && !is_out(arc, turn, up))
        turn += up ? fine_angle : -fine_angle;
      const bool ends = std::abs(turn) <= half;
      if (up) add(arc, -half, ends ? turn : half);
      if (!up) add(arc, ends ? turn : -half, half);
      if (ends || std::abs(arc) > 1000) return;
    }
  };
  follow(true);
  follow(false);
}

void ExactLattice::add_sides() {
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    const Strip& s = strips_[i];
    for (const bool outer : {false, true}) {
      const double start = s.start + (outer ? s.half : -s.half);
      sides_.push_back({false, start, s.cotangent, 0, 0, 0, 0, length_, outer, i});
    }
  }
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const Arc& a = arcs_[i];
    const std::size_t shape = strips_.size() + i;
    sides_.push_back({true, 0, 0, a.u, a.z, a.outer, a.from, a.to, true, shape});
    if (a.inner > 0) sides_.push_back({true, 0, 0, a.u, a.z, a.inner, a.from, a.to, false, shape});
  }
}

void ExactLattice::add_ends() {
  for (const double z : {0.0, length_}) {
    std::vector<double> breaks = level_crossings(z);
    if (breaks.empty()) breaks.push_back(0);
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      const double next = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + circumference_;
      if (!covered(0.5 * (breaks[i] + next), z, none, none)) continue;
      if (!ends_.empty() && ends_.back().z == z && ends_.back().to == breaks[i]) {
        ends_.back().to = next;
      } else {
        ends_.push_back({z, breaks[i], next});
      }
    }
  }
}

double ExactLattice::wrapped(double u) const {
  return std::remainder(u, circumference_);
}

bool ExactLattice::in_strip(const Strip& strip, double u, double z) const {
  return std::abs(wrapped(u - strip.start - z * strip.cotangent)) <= strip.half;
}

bool ExactLattice::in_arc(const Arc& arc, double u, double z) const {
  const double du = wrapped(u - arc.u);
  const double dz = z - arc.z;
  const double r = std::hypot(du, dz);
  return r >= arc.inner && r <= arc.outer && between_angles(std::atan2(dz, du), arc.from, arc.to);
}

bool ExactLattice::covered(double u, double z, std::size_t but_shape, std::size_t but_ring) const {
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    if (i != but_ring && z >= rings_[i].low && z <= rings_[i].high) return true;
  }
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (i != but_shape && in_strip(strips_[i], u, z)) return true;
  }
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    if (i + strips_.size() != but_shape && in_arc(arcs_[i], u, z)) return true;
  }
  return false;
}

Depth ExactLattice::depth_in_strip(const Strip& strip, double u, double z) const {
  const double off = wrapped(u - strip.start - z * strip.cotangent);
  const double sine = 1 / std::hypot(1, strip.cotangent);
  const double outward = off > 0 ? 1 : -1;
  return {(strip.half - std::abs(off)) * sine, -outward * sine, outward * strip.cotangent * sine};
}

Depth ExactLattice::depth_in_arc(const Arc& arc, double u, double z) const {
  const Vector off{wrapped(u - arc.u), z - arc.z};
  const double r = off.length();
  if (between_angles(std::atan2(off.z, off.u), arc.from, arc.to)) {
    const bool to_outer = arc.inner == 0 || r > 0.5 * (arc.inner + arc.outer);
    const double sign = to_outer ? -1 : 1;
    return {to_outer ? arc.outer - r : r - arc.inner, sign * off.u / r, sign * off.z / r};
  }
  Depth nearest{-HUGE_VAL, 0, 1};
  for (const double angle : {arc.from, arc.to}) {
    const Vector radial{std::cos(angle), std::sin(angle)};
    const Depth depth = toward_segment(off, arc.inner * radial, arc.outer * radial);
    if (depth.mm > nearest.mm) nearest = depth;
  }
  return nearest;
}

Depth ExactLattice::plain_depth(double u, double z) const {
  Depth deepest{-HUGE_VAL, 0, 1};
  const auto take = [&](const Depth& depth) {
    if (depth.mm > deepest.mm) deepest = depth;
  };
  for (const Ring& ring : rings_) {
    if (ring.low > 0 || ring.high < length_) {
      const bool at_low =
          ring.high == length_ || (ring.low > 0 && z < 0.5 * (ring.low + ring.high));
      take(at_low ? Depth{z - ring.low, 0, 1} : Depth{ring.high - z, 0, -1});
    }
  }
  for (const Strip& strip : strips_) take(depth_in_strip(strip, u, z));
  for (const Arc& arc : arcs_) {
    const double far = arc.outer - std::hypot(wrapped(u - arc.u), z - arc.z);
    if (far > deepest.mm) take(depth_in_arc(arc, u, z));
  }
  return deepest;
}

double ExactLattice::gap_to_material(double u, double z) const {
  if (z >= 0 && z <= length_ && covered(u, z, none, none)) return 0;
  double gap = HUGE_VAL;
  for (const Ring& ring : rings_) gap = std::min(gap, std::max(ring.low - z, z - ring.high));
  for (const End& end : ends_) {
    const double beyond =
        std::abs(wrapped(u - 0.5 * (end.from + end.to))) - 0.5 * (end.to - end.from);
    gap = std::min(gap, std::hypot(z - end.z, std::max(0.0, beyond)));
  }
  for (const Side& side : sides_) {
    if (side.round) {
      const Vector off{wrapped(u - side.u), z - side.z};
      const double r = off.length();
      if (std::abs(r - side.radius) >= gap) continue;
      if (!between_angles(std::atan2(off.z, off.u), side.from, side.to)) continue;
      const double foot = side.z + side.radius * off.z / r;
      if (foot >= 0 && foot <= length_) gap = std::min(gap, std::abs(r - side.radius));
    } else {
      const double off = wrapped(u - side.start - z * side.cotangent);
      const double square = 1 + side.cotangent * side.cotangent;
      const double foot = z + off * side.cotangent / square;
      if (foot >= 0 && foot <= length_) gap = std::min(gap, std::abs(off) / std::sqrt(square));
    }
  }
  return gap;
}

// What fillets leave open are discs of their radius that lie beside the lattice: the depth is the
// distance to the nearest middle of such a disc, less the radius.
Depth ExactLattice::filleted_depth(double u, double z, double reach) const {
  std::vector<Curve> offsets;  // seen from the place
  const double far = 2 * fillet_ + reach;
  const auto add_level = [&](double level) {
    if (std::abs(level - z) <= far) offsets.push_back({{0, level - z}, {1, 0}, 0});
  };
  for (const Ring& ring : rings_) {
    add_level(ring.low - fillet_);
    add_level(ring.high + fillet_);
  }
  add_level(-fillet_);
  add_level(length_ + fillet_);
  for (const End& end : ends_) {
    for (const double at : {end.from, end.to}) {
      const Vector corner{-wrapped(u - at), end.z - z};
      if (corner.length() <= far) offsets.push_back({corner, {}, fillet_});
    }
  }
  for (const Side& side : sides_) {
    const double sign = side.outer ? 1 : -1;
    if (side.round) {
      const Vector centre{-wrapped(u - side.u), side.z - z};
      const double radius = side.radius + sign * fillet_;
      if (radius > 0 && std::abs(centre.length() - side.radius) <= far) {
        offsets.push_back({centre, {}, radius});
      }
    } else {
      const double size = std::hypot(1, side.cotangent);
      const Vector direction{side.cotangent / size, 1 / size};
      const Vector outward = sign * Vector{direction.z, -direction.u};
      const double off = wrapped(u - side.start - z * side.cotangent);
      if (std::abs(off) / size > far) continue;
      offsets.push_back({Vector{-off, 0} + fillet_ * outward, direction, 0});
    }
  }
  std::vector<Vector> middles;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    middles.push_back(foot_of_origin(offsets[i]));
    for (std::size_t j = 0; j < i; ++j) add_meetings(offsets[i], offsets[j], middles);
  }
  std::erase_if(middles, [&](Vector m) { return !(m.length() <= fillet_ + reach); });
  std::sort(middles.begin(), middles.end(),
            [](Vector a, Vector b) { return a.length() < b.length(); });
  for (const Vector& m : middles) {
    if (gap_to_material(u + m.u, z + m.z) < fillet_ * (1 - 1e-9)) continue;
    const double size = m.length();
    return {size - fillet_, -m.u / size, -m.z / size};
  }
  return {reach, 0, 1};
}

Depth ExactLattice::depth(double u, double z, double reach_mm) const {
  Depth depth = plain_depth(u, z);
  if (fillet_ > 0 && depth.mm < reach_mm) depth = filleted_depth(u, z, reach_mm);
  if (z < depth.mm) depth = {z, 0, 1};
  if (length_ - z < depth.mm) depth = {length_ - z, 0, -1};
  return depth;
}

// Where the other side may begin to cover this one, as z of a straight side or as an angle.
std::vector<double> ExactLattice::crossings(const Side& side, const Side& other) const {
  std::vector<double> at;
  if (!side.round && !other.round) {
    const double slopes = side.cotangent - other.cotangent;
    if (slopes == 0) return at;
    const double apart = other.start - side.start;
    const double low = std::min(0.0, slopes * length_) - apart;
    const double high = std::max(0.0, slopes * length_) - apart;
    for (double k = std::ceil(low / circumference_); k <= high / circumference_; ++k) {
      at.push_back((apart + k * circumference_) / slopes);
    }
    return at;
  }
  const Side& circle = side.round ? side : other;
  const Curve round{{circle.u, circle.z}, {}, circle.radius};
  std::vector<Vector> points;
  if (side.round && other.round) {
    for (int k = -1; k <= 1; ++k) {
      const double u = side.u + wrapped(other.u - side.u) + k * circumference_;
      add_circles(round, {{u, other.z}, {}, other.radius}, points);
    }
  } else {
    const Side& line = side.round ? other : side;
    const double size = std::hypot(1, line.cotangent);
    const Vector direction{line.cotangent / size, 1 / size};
    const double reach = circle.radius * size;
    const double middle = circle.u - line.start - circle.z * line.cotangent;
    const double first = std::ceil((middle - reach) / circumference_);
    for (double k = first; k <= (middle + reach) / circumference_; ++k) {
      add_line_circle({{line.start + k * circumference_, 0}, direction, 0}, round, points);
    }
  }
  for (const Vector& p : points) {
    if (!side.round) {
      at.push_back(p.z);
      continue;
    }
    const double turn = std::atan2(p.z - side.z, p.u - side.u) - side.from;
    at.push_back(side.from + turn - 2 * pi * std::floor(turn / (2 * pi)));
  }
  return at;
}

std::vector<double> ExactLattice::level_crossings(double z) const {
  std::vector<double> at;
  for (const Side& side : sides_) {
    if (side.round) {
      const double dz = z - side.z;
      if (std::abs(dz) >= side.radius) continue;
      const double du = std::sqrt(side.radius * side.radius - dz * dz);
      at.push_back(side.u - du);
      at.push_back(side.u + du);
    } else {
      at.push_back(side.start + z * side.cotangent);
    }
  }
  for (double& u : at) u -= circumference_ * std::floor(u / circumference_);
  std::sort(at.begin(), at.end());
  return at;
}

// Of the outline's part on one side, by Green's theorem: minus the integral of z du, with material
// on the left.
double ExactLattice::area_of(const Side& side) const {
  std::vector<double> breaks{side.from, side.to};
  for (const Side& other : sides_) {
    if (other.shape == side.shape) continue;
    for (const double at : crossings(side, other)) breaks.push_back(at);
  }
  std::vector<double> levels{0, length_};
  for (const Ring& ring : rings_) levels.insert(levels.end(), {ring.low, ring.high});
  for (const double level : levels) {
    if (!side.round) {
      breaks.push_back(level);
    } else if (const double sine = (level - side.z) / side.radius; std::abs(sine) < 1) {
      for (const double angle : {std::asin(sine), pi - std::asin(sine)}) {
        const double turn = angle - side.from;
        breaks.push_back(side.from + turn - 2 * pi * std::floor(turn / (2 * pi)));
      }
    }
  }
  std::erase_if(breaks, [&](double at) { return !(at >= side.from && at <= side.to); });
  std::sort(breaks.begin(), breaks.end());
  const auto integral = [&](double at) {
    if (!side.round) return -0.5 * side.cotangent * at * at;
    return -side.z * side.radius * std::cos(at) +
           side.radius * side.radius * (0.5 * at - 0.25 * std::sin(2 * at));
  };
  double area = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double at = 0.5 * (breaks[i] + breaks[i + 1]);
    const double u =
        side.round ? side.u + side.radius * std::cos(at) : side.start + at * side.cotangent;
    const double z = side.round ? side.z + side.radius * std::sin(at) : at;
    if (z < 0 || z > length_ || covered(u, z, side.shape, none)) continue;
    area += integral(breaks[i + 1]) - integral(breaks[i]);
  }
  return side.outer ? area : -area;
}

double ExactLattice::level_length(double z, std::size_t but_ring, bool wants_covered) const {
  std::vector<double> breaks = level_crossings(z);
  if (breaks.empty()) breaks.push_back(0);
  double length = 0;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const double next = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + circumference_;
    const bool is_covered = covered(0.5 * (breaks[i] + next), z, none, but_ring);
    if (is_covered == wants_covered) length += next - breaks[i];
  }
  return length;
}

double ExactLattice::area_mm2() const {
  double area = length_ * level_length(length_, none, true);
  for (const Side& side : sides_) area += area_of(side);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    if (rings_[i].low > 0) area -= rings_[i].low * level_length(rings_[i].low, i, false);
    if (rings_[i].high < length_) area += rings_[i].high * level_length(rings_[i].high, i, false);
  }
  return area;
}

}  // namespace latticast
