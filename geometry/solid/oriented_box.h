// SPDX-License-Identifier: GPL-3.0-or-later
// Oriented bounding boxes of triangles, and a test that two of them are apart.
#pragma once

#include <array>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// A box with edges in any direction. One around a long thin triangle is as thin as the triangle,
/// however the triangle lies. Precondition: coordinates below 1e140.
struct OrientedBox {
  Point middle{};
  std::array<Point, 3> axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};  ///< orthonormal
  Point half{};  ///< half of the box's size along each axis

  /// Along the longest edge and the plane of the triangle; of a triangle too small to have
  /// directions, along the coordinates. Sides reach out by the margin: 1e-12 of the largest
  /// coordinate of all triangles that are to be compared, so that rounding never parts what
  /// touches, also in boxes of a million boxes.
  static OrientedBox around(const Point& a, const Point& b, const Point& c, double margin);

  /// Around both, along the longer one.
  static OrientedBox around(const OrientedBox& a, const OrientedBox& b);

  /// Does no side of either box part them? True for all boxes that meet, and for some that are
  /// parted only by a plane askew to both.
  bool may_meet(const OrientedBox& other) const;
};

}  // namespace latticast
