// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace latticast {
namespace {

constexpr double series_below = 0.5;

Rotation product(const Rotation& a, const Rotation& b) {
  Rotation c{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return c;
}

Point turned(const Rotation& rotation, const Point& p) {
  Point q{};
  for (int i = 0; i < 3; ++i) {
    q[i] = rotation[i][0] * p[0] + rotation[i][1] * p[1] + rotation[i][2] * p[2];
  }
  return q;
}

/// (t - sin t)/t^3. Below 0.5 the series' next term is under 1e-18 of the first.
double three_halves_sine(double t) {
  const double square = t * t;
  if (std::abs(t) >= series_below) return (t - std::sin(t)) / (square * t);
  double term = 1.0 / 6;
  double sum = term;
  for (int n = 4; n <= 16; n += 2) {
    term *= -square / (n * (n + 1));
    sum += term;
  }
  return sum;
}

/// (1 - cos t)/t^2.
double half_square_sine(double t) {
  if (t == 0) return 0.5;
  const double half = std::sin(0.5 * t) / t;
  return 2 * half * half;
}

/// exp([v] z) as a unit quaternion's matrix: orthonormal to rounding for any angle.
Rotation screw_rotation(const Point& v, double z) {
  const double size = std::hypot(v[0], v[1], v[2]);
  const double half = 0.5 * size * z;
  const double share = size == 0 ? 0.5 * z : std::sin(half) / size;
  const double w = std::cos(half);
  const double x = v[0] * share;
  const double y = v[1] * share;
  const double t = v[2] * share;
  return {{{1 - 2 * (y * y + t * t), 2 * (x * y - t * w), 2 * (x * t + y * w)},
           {2 * (x * y + t * w), 1 - 2 * (x * x + t * t), 2 * (y * t - x * w)},
           {2 * (x * t - y * w), 2 * (y * t + x * w), 1 - 2 * (x * x + y * y)}}};
}

Rotation about_axis(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

}  // namespace

double tilt_rad(const Rotation& rotation) {
  return std::atan2(std::hypot(rotation[0][2], rotation[1][2]), rotation[2][2]);
}

Frame composed(const Frame& outer, const Frame& inner) {
  Frame result{turned(outer.rotation, inner.origin), product(outer.rotation, inner.rotation)};
  for (int i = 0; i < 3; ++i) result.origin[i] += outer.origin[i];
  return result;
}

Frame frame_along(const State& state, double z_mm) {
  const auto [kappa_1, kappa_2] = state.bend_rad_per_mm;
  if (kappa_1 == 0 && kappa_2 == 0) {
    return {{0, 0, state.stretch * z_mm}, about_axis(state.twist_rad_per_mm * z_mm)};
  }
  const double turn = state.frame_turn_rad_per_mm;
  const Point v = {kappa_2, -kappa_1, state.twist_rad_per_mm + turn};
  const double angle = std::hypot(v[0], v[1], v[2]) * z_mm;
  // Integral of exp([v] s) e_z: z e_z + (1 - cos) [v] e_z / |v|^2 + (angle - sin) [v]^2 e_z /
  // |v|^3.
  const double first = half_square_sine(angle) * z_mm * z_mm;
  const double second = three_halves_sine(angle) * z_mm * z_mm * z_mm;
  const double across = v[0] * v[0] + v[1] * v[1];
  const Point line = {first * v[1] + second * v[0] * v[2], -first * v[0] + second * v[1] * v[2],
                      z_mm - second * across};
  return {{state.stretch * line[0], state.stretch * line[1], state.stretch * line[2]},
          product(screw_rotation(v, z_mm), about_axis(-turn * z_mm))};
}

Shape::Shape(std::span<const Segment> segments, std::span<const State> states) {
  if (segments.empty() || segments.size() != states.size()) {
    throw std::invalid_argument("a shape needs one state for each of its segments");
  }
  double rest = 0;
  Frame frame;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    pieces_.push_back({rest, segment.length_mm, segment.inner_radius_mm(), frame, states[i]});
    rest += segment.length_mm;
    frame = composed(frame, frame_along(states[i], segment.length_mm));
  }
}

std::size_t Shape::segment_at(double z_mm) const {
  const auto above =
      std::upper_bound(pieces_.begin(), pieces_.end(), z_mm,
                       [](double z, const Piece& piece) { return z < piece.rest_begin_mm; });
  return above == pieces_.begin() ? 0 : static_cast<std::size_t>(above - pieces_.begin()) - 1;
}

Point Shape::moved(const Point& rest) const {
  return moved(rest, segment_at(rest[2]));
}

Point Shape::moved(const Point& rest, std::size_t segment) const {
  const Piece& piece = pieces_.at(segment);
  const double radius = std::hypot(rest[0], rest[1]);
  const Deformation q = piece.state.deformation(piece.inner_radius_mm);
  const double growth = radius < piece.inner_radius_mm
                            ? piece.state.inner_radius_mm / piece.inner_radius_mm
                            : current_radius_mm(piece.inner_radius_mm, radius, q) / radius;
  // The vector is turned instead of its polar angle: axis and seam are no special cases.
  const Frame frame = frame_at(segment, rest[2] - piece.rest_begin_mm);
  Point point = turned(frame.rotation, {growth * rest[0], growth * rest[1], 0});
  for (int i = 0; i < 3; ++i) point[i] += frame.origin[i];
  return point;
}

double Shape::z_begin_mm(std::size_t segment) const {
  return pieces_.at(segment).rest_begin_mm;
}

double Shape::z_end_mm(std::size_t segment) const {
  return pieces_.at(segment).rest_begin_mm + pieces_.at(segment).rest_length_mm;
}

Frame Shape::frame_at(std::size_t segment, double along_mm) const {
  const Piece& piece = pieces_.at(segment);
  return composed(piece.begin, frame_along(piece.state, along_mm));
}

Frame Shape::tip() const {
  return frame_at(pieces_.size() - 1, pieces_.back().rest_length_mm);
}

std::vector<Point> Shape::centre_line(int steps) const {
  std::vector<Point> line;
  for (std::size_t s = 0; s < pieces_.size(); ++s) {
    for (int i = s == 0 ? 0 : 1; i <= steps; ++i) {
      line.push_back(frame_at(s, pieces_[s].rest_length_mm * i / steps).origin);
    }
  }
  return line;
}

double Shape::length_mm() const {
  double length = 0;
  for (const Piece& piece : pieces_) length += piece.state.stretch * piece.rest_length_mm;
  return length;
}

double Shape::end_rotation_rad() const {
  double rotation = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) rotation += twist_rad(i);
  return rotation;
}

double Shape::twist_rad(std::size_t segment) const {
  return pieces_.at(segment).state.twist_rad_per_mm * pieces_.at(segment).rest_length_mm;
}

double Shape::bend_rad(std::size_t segment) const {
  const Piece& piece = pieces_.at(segment);
  return piece.state.bend_magnitude_rad_per_mm() * piece.rest_length_mm;
}

double Shape::bend_direction_rad(std::size_t segment) const {
  return pieces_.at(segment).state.bend_direction_rad();
}

double Shape::curving_rad_per_mm(std::size_t segment) const {
  const State& state = pieces_.at(segment).state;
  const double twist = std::abs(state.twist_rad_per_mm);
  const double bend = state.bend_magnitude_rad_per_mm();
  if (bend == 0) return twist;
  return std::sqrt(twist * twist + bend * bend + std::abs(state.frame_turn_rad_per_mm) * bend +
                   state.stretch * bend / state.outer_radius_mm);
}

double Shape::largest_stretch(std::size_t segment) const {
  const Piece& piece = pieces_.at(segment);
  const State& state = piece.state;
  // r/R runs from a/R_i towards 1/sqrt(lambda) as R grows.
  const double bore = state.inner_radius_mm / piece.inner_radius_mm;
  const double far_out = 1 / std::sqrt(state.stretch);
  const double around = std::max(bore, far_out);
  const double along = state.stretch + state.bend_magnitude_rad_per_mm() * state.outer_radius_mm;
  const double shear = state.twist_rad_per_mm * state.outer_radius_mm;
  const double radial = 1 / (state.stretch * std::min(bore, far_out));
  const double in_surface =
      0.5 * (std::hypot(around + along, shear) + std::hypot(around - along, shear));
  return std::max(radial, in_surface);
}

double Shape::least_stretch(std::size_t segment) const {
  const Piece& piece = pieces_.at(segment);
  const State& state = piece.state;
  const double around =
      std::min(state.inner_radius_mm / piece.inner_radius_mm, 1 / std::sqrt(state.stretch));
  const double along = state.stretch - state.bend_magnitude_rad_per_mm() * state.outer_radius_mm;
  return std::max(0.0, around * along / largest_stretch(segment));
}

double Shape::longest_straight_mm(std::size_t segment, double tolerance_mm) const {
  const double curving = curving_rad_per_mm(segment);
  if (curving == 0) return std::numeric_limits<double>::infinity();
  // Beyond a diameter every chord of the helix is within tolerance; half a turn is then ample.
  const double cosine =
      std::max(-1.0, 1 - tolerance_mm / pieces_.at(segment).state.outer_radius_mm);
  return 2 * std::acos(cosine) / curving;
}

}  // namespace latticast
