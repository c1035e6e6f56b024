// SPDX-License-Identifier: GPL-3.0-or-later
// The map of space that a chain of inflated segments makes (MODEL.md section 7, paper (6)).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "model/response.h"
#include "spec/design.h"

namespace latticast {

/// Moves points of the rest chain to where the given states carry them. Segment i occupies
/// z_begin(i) <= z <= z_end(i) of the rest chain, the first one starting at z = 0; each segment's
/// end frame is the next one's start, so lengths and twists add up:
///     r = r(R),  theta = Theta + (twist of the segments below) + k Z,  z = (their length) + lambda
///     Z.
class Shape {
 public:
  /// One state per segment. Throws std::invalid_argument when the counts differ or are zero.
  Shape(std::span<const Segment> segments, std::span<const State> states);

  /// The moved point. z decides on the segment: an interface belongs to the segment above it, and
  /// points below or above the chain follow the first or last segment's map. R = 0 stays on the
  /// axis; inside the bore the radius is scaled by a/R_i.
  Point moved(const Point& rest) const;

  /// The moved point, taken as a point of `segment` wherever its z lies: for meshes of one segment,
  /// whose end faces at an interface must move with their own segment.
  Point moved(const Point& rest, std::size_t segment) const;

  std::size_t segment_count() const { return pieces_.size(); }
  double z_begin_mm(std::size_t segment) const;  ///< in the rest chain
  double z_end_mm(std::size_t segment) const;    ///< in the rest chain

  double length_mm() const;                     ///< of the whole chain, moved
  double end_rotation_rad() const;              ///< of the far end against the near end
  double twist_rad(std::size_t segment) const;  ///< k L, of one segment alone

  /// Longest axial rest distance between mesh vertices of a segment for which a straight line at
  /// the outer surface, moved, departs from its chord by no more than `tolerance_mm` (> 0): 2
  /// acos(1 - tolerance/r) / |k|. Infinite for an untwisted segment.
  double longest_straight_mm(std::size_t segment, double tolerance_mm) const;

 private:
  struct Piece {
    double rest_begin_mm, rest_length_mm, moved_begin_mm, rotation_begin_rad;
    double inner_radius_mm, outer_radius_mm;  // outer: moved
    Deformation deformation;
  };

  std::size_t segment_at(double z_mm) const;

  std::vector<Piece> pieces_;
};

}  // namespace latticast
