// SPDX-License-Identifier: GPL-3.0-or-later
// Deformation map of a chain of inflated segments, by closed-form screw motions
// (docs/bending.md#shape, [Wang] (6), (28), (29)).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "design/design.h"
#include "geometry/mesh/triangle_mesh.h"
#include "model/equilibrium/state.h"

namespace latticast {

/// Rows of a rotation matrix; its columns are the moved directions of Theta = 0, Theta = 90 degrees
/// and +z.
using Rotation = std::array<std::array<double, 3>, 3>;

/// A cross-section's place: its centre in mm, and its orientation.
struct Frame {
  Point origin{};
  Rotation rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// The angle in rad between a section's axis and the base's, 0 to pi; exact also where they are
/// nearly parallel.
double tilt_rad(const Rotation& rotation);

/// Where `inner`, given in the axes of `outer`, lies: (28), (29).
Frame composed(const Frame& outer, const Frame& inner);

/// The cross-section at reference height `z_mm` of one segment that starts at the origin along +z.
/// In a frame that turns with the columns at omega against the material, the Darboux vector per
/// reference length is constant, v = (kappa_2, -kappa_1, k + omega): a screw motion, written in
/// closed form and without cancellation for any size of v z. Rotations are orthonormal to rounding.
Frame frame_along(const State& state, double z_mm);

/// Moves points of the rest chain to where the given states carry them. Segment i occupies
/// z_begin(i) <= z <= z_end(i) of the rest chain, the first one starting at z = 0; each segment's
/// end frame is the next one's start. A point (R, Theta, Z) goes to the centre line at Z plus r(R)
/// in the direction Theta of that section.
class Shape {
 public:
  /// One state per segment. Throws std::invalid_argument when the counts differ or are zero.
  Shape(std::span<const Segment> segments, std::span<const State> states);

  /// The moved point. z decides on the segment: an interface belongs to the segment above it, and
  /// points below or above the chain follow the first or last segment's map. R = 0 stays on the
  /// centre line; inside the bore the radius is scaled by a/R_i.
  Point moved(const Point& rest) const;

  /// The moved point, taken as a point of `segment` wherever its z lies: for meshes of one segment,
  /// whose end faces at an interface must move with their own segment.
  Point moved(const Point& rest, std::size_t segment) const;

  std::size_t segment_count() const { return pieces_.size(); }
  double z_begin_mm(std::size_t segment) const;  ///< in the rest chain
  double z_end_mm(std::size_t segment) const;    ///< in the rest chain

  /// The section of `segment` at `along_mm` of its own rest length.
  Frame frame_at(std::size_t segment, double along_mm) const;
  Frame tip() const;  ///< the far end's section

  /// The moved centre line: both ends of every segment and `steps` >= 1 equal steps on each.
  std::vector<Point> centre_line(int steps) const;

  double length_mm() const;                     ///< of the whole centre line, moved
  double end_rotation_rad() const;              ///< twists of all segments together
  double twist_rad(std::size_t segment) const;  ///< k L, of one segment alone
  double bend_rad(std::size_t segment) const;   ///< |kappa| L, of one segment alone

  /// Theta in [0, 2 pi) of the segment's own material toward which it bends at its base; 0 when it
  /// is straight.
  double bend_direction_rad(std::size_t segment) const;

  /// A twist in rad/mm that curves lines along the outer surface at least as much as this segment's
  /// twist and bending do; |k| where it does not bend. From |p''| <= lambda |kappa| + r (k^2 +
  /// |kappa|^2 + |omega kappa|).
  double curving_rad_per_mm(std::size_t segment) const;

  /// At least the factor by which any short line in the segment's wall becomes longer: the largest
  /// singular value of F (docs/model.md#coordinates) with each entry as large as it is anywhere.
  double largest_stretch(std::size_t segment) const;

  /// At most the factor by which any short line on the lattice's faces becomes shorter: the
  /// smallest singular value of F in the wall, with each entry as it is least favourable anywhere.
  double least_stretch(std::size_t segment) const;

  /// Longest axial rest distance between mesh vertices of a segment for which a straight line at
  /// the outer surface, moved, departs from its chord by no more than `tolerance_mm` (> 0): 2
  /// acos(1 - tolerance/r) / curving. Infinite for a straight segment.
  double longest_straight_mm(std::size_t segment, double tolerance_mm) const;

 private:
  struct Piece {
    double rest_begin_mm, rest_length_mm, inner_radius_mm;
    Frame begin;
    State state;
  };

  std::size_t segment_at(double z_mm) const;

  std::vector<Piece> pieces_;
};

}  // namespace latticast
