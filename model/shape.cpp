// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace latticast {

Shape::Shape(std::span<const Segment> segments, std::span<const State> states) {
  if (segments.empty() || segments.size() != states.size()) {
    throw std::invalid_argument("a shape needs one state for each of its segments");
  }
  double rest = 0;
  double moved = 0;
  double rotation = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Deformation q = states[i].deformation(segment.inner_radius_mm());
    pieces_.push_back({rest, segment.length_mm, moved, rotation, segment.inner_radius_mm(),
                       states[i].outer_radius_mm, q});
    rest += segment.length_mm;
    moved += segment.length_mm * (1 + q.elongation);
    rotation += segment.length_mm * q.twist;
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
  const double along = rest[2] - piece.rest_begin_mm;
  const double growth =
      radius < piece.inner_radius_mm
          ? 1 + piece.deformation.inner_growth / piece.inner_radius_mm
          : current_radius_mm(piece.inner_radius_mm, radius, piece.deformation) / radius;
  // Turning the vector instead of its polar angle keeps the axis and the seam free of special
  // cases.
  const double angle = piece.rotation_begin_rad + piece.deformation.twist * along;
  const double cosine = growth * std::cos(angle);
  const double sine = growth * std::sin(angle);
  return {cosine * rest[0] - sine * rest[1], sine * rest[0] + cosine * rest[1],
          piece.moved_begin_mm + (1 + piece.deformation.elongation) * along};
}

double Shape::z_begin_mm(std::size_t segment) const {
  return pieces_.at(segment).rest_begin_mm;
}

double Shape::z_end_mm(std::size_t segment) const {
  return pieces_.at(segment).rest_begin_mm + pieces_.at(segment).rest_length_mm;
}

double Shape::length_mm() const {
  const Piece& last = pieces_.back();
  return last.moved_begin_mm + (1 + last.deformation.elongation) * last.rest_length_mm;
}

double Shape::end_rotation_rad() const {
  return pieces_.back().rotation_begin_rad + twist_rad(pieces_.size() - 1);
}

double Shape::twist_rad(std::size_t segment) const {
  const Piece& piece = pieces_.at(segment);
  return piece.deformation.twist * piece.rest_length_mm;
}

double Shape::longest_straight_mm(std::size_t segment, double tolerance_mm) const {
  const Piece& piece = pieces_.at(segment);
  const double twist = std::abs(piece.deformation.twist);
  if (twist == 0) return std::numeric_limits<double>::infinity();
  // Beyond a diameter every chord of the helix is within tolerance; half a turn is then ample.
  const double cosine = std::max(-1.0, 1 - tolerance_mm / piece.outer_radius_mm);
  return 2 * std::acos(cosine) / twist;
}

}  // namespace latticast
