// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/oriented_box.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/point_algebra.h"

namespace latticast {
namespace {

// Makes a vector one long; says whether its direction can be told from rounding.
bool normalise(Point& v) {
  const double squared = dot(v, v);
  if (!(squared >= 1e-280 && squared <= 1e280)) return false;
  const double scale = 1 / std::sqrt(squared);
  for (double& x : v) x *= scale;
  return true;
}

// Takes from v its part along a unit vector; says whether a direction is left. The second round
// removes what the first one's rounding left of it in a v that is nearly along.
bool make_square_to(const Point& along, Point& v) {
  for (int round = 0; round < 2; ++round) {
    const double part = dot(v, along);
    for (int i = 0; i < 3; ++i) v[i] -= part * along[i];
    if (!normalise(v)) return false;
  }
  return true;
}

// How far a box reaches from its middle in a direction.
double reach(const OrientedBox& box, const Point& direction) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += box.half[i] * std::abs(dot(box.axes[i], direction));
  return sum;
}

// Moves the middle to the middle of the bounds along every axis, given from the middle.
void take_bounds(OrientedBox& box, const Point& low, const Point& high) {
  for (int i = 0; i < 3; ++i) {
    box.half[i] = 0.5 * (high[i] - low[i]);
    const double shift = 0.5 * (high[i] + low[i]);
    for (int k = 0; k < 3; ++k) box.middle[k] += shift * box.axes[i][k];
  }
}

}  // namespace

OrientedBox OrientedBox::around(const Point& a, const Point& b, const Point& c, double margin) {
  const std::array<Point, 3> edges{difference(b, a), difference(c, b), difference(a, c)};
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (dot(edges[i], edges[i]) > dot(edges[longest], edges[longest])) longest = i;
  }
  OrientedBox box;
  box.middle = a;
  if (Point along = edges[longest], across = edges[(longest + 1) % 3];
      normalise(along) && make_square_to(along, across)) {
    box.axes = {along, across, cross(along, across)};
  }
  Point low{};
  Point high{};
  for (int i = 0; i < 3; ++i) {
    for (const Point& corner : {b, c}) {
      const double x = dot(difference(corner, a), box.axes[i]);
      low[i] = std::min(low[i], x);
      high[i] = std::max(high[i], x);
    }
  }
  take_bounds(box, low, high);
  for (double& half : box.half) half += margin;
  return box;
}

OrientedBox OrientedBox::around(const OrientedBox& a, const OrientedBox& b) {
  const auto length = [](const OrientedBox& box) {
    return *std::max_element(box.half.begin(), box.half.end());
  };
  const bool along_a = length(a) >= length(b);
  OrientedBox box = along_a ? a : b;
  const OrientedBox& other = along_a ? b : a;
  const Point between = difference(other.middle, box.middle);
  Point low{};
  Point high{};
  for (int i = 0; i < 3; ++i) {
    const double place = dot(between, box.axes[i]);
    const double reached = reach(other, box.axes[i]);
    low[i] = std::min(-box.half[i], place - reached);
    high[i] = std::max(box.half[i], place + reached);
  }
  take_bounds(box, low, high);
  return box;
}

bool OrientedBox::may_meet(const OrientedBox& other) const {
  const Point between = difference(other.middle, middle);
  Point reached = other.half;  // by both boxes, along each axis of the other
  for (int i = 0; i < 3; ++i) {
    double sum = half[i];
    for (int j = 0; j < 3; ++j) {
      const double cosine = std::abs(dot(axes[i], other.axes[j]));
      sum += cosine * other.half[j];
      reached[j] += cosine * half[i];
    }
    if (std::abs(dot(between, axes[i])) > sum) return false;
  }
  for (int j = 0; j < 3; ++j) {
    if (std::abs(dot(between, other.axes[j])) > reached[j]) return false;
  }
  return true;
}

}  // namespace latticast
