// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/rasteriser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticast {
namespace {

struct Range {
  int first;
  int last;
};

/// The sample centres from `low` to `high` that exist.
Range samples_between(double low, double high, int count) {
  const double limit = count;
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, limit)),
          static_cast<int>(std::clamp(std::floor(high - 0.5), -1.0, limit - 1))};
}

/// Twice the signed area left of a -> b that p spans.
double side(const Point& a, const Point& b, double x, double y) {
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

}  // namespace

void draw_triangle(Layer& layer, const std::array<Point, 3>& corners, std::uint32_t facet) {
  const Point& a = corners[0];
  Point b = corners[1];
  Point c = corners[2];
  if (side(a, b, c[0], c[1]) < 0) {
    std::swap(b, c);
  }
  const double area = side(a, b, c[0], c[1]);
  if (!(area > 0)) {
    return;
  }
  const Range columns =
      samples_between(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), layer.width);
  const Range rows =
      samples_between(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), layer.height);
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const double of_a = side(b, c, x, y);
      const double of_b = side(c, a, x, y);
      const double of_c = side(a, b, x, y);
      if (of_a < 0 || of_b < 0 || of_c < 0) {
        continue;
      }
      const auto depth = static_cast<float>((of_a * a[2] + of_b * b[2] + of_c * c[2]) / area);
      const std::size_t sample = static_cast<std::size_t>(row) * layer.width + column;
      if (depth < layer.depth[sample]) {
        layer.depth[sample] = depth;
        layer.facet[sample] = facet;
      }
    }
  }
}

}  // namespace latticast
