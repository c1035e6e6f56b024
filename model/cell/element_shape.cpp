// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/element_shape.h"

#include "model/numerics/gauss.h"

namespace latticast {
namespace {

/// Lagrange's parabolas through -1, 0 and 1.
struct Parabolas {
  std::array<double, 3> value;
  std::array<double, 3> slope;

  explicit Parabolas(double x)
      : value{0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)}, slope{x - 0.5, -2 * x, x + 0.5} {}
};

ShapeAtPoint at_point(int axes, const std::array<double, 3>& place, double weight) {
  const Parabolas x(place[0]);
  const Parabolas y(place[1]);
  const Parabolas z(place[2]);
  ShapeAtPoint point{.weight = weight, .place = place, .value = {}, .slope = {}};
  for (std::size_t k = 0; k < (axes == 3 ? 3U : 1U); ++k) {
    const double along_z = axes == 3 ? z.value[k] : 1;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        point.value.push_back(x.value[i] * y.value[j] * along_z);
        point.slope.push_back({x.slope[i] * y.value[j] * along_z, x.value[i] * y.slope[j] * along_z,
                               axes == 3 ? x.value[i] * y.value[j] * z.slope[k] : 0});
      }
    }
  }
  return point;
}

ElementShape made(int axes, int count) {
  const GaussRule rule = gauss_legendre(count);
  ElementShape shape;
  shape.nodes = axes == 3 ? 27 : 9;
  const auto n = static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < (axes == 3 ? n : 1); ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const double weight = rule.weights[i] * rule.weights[j] * (axes == 3 ? rule.weights[k] : 1);
        const std::array<double, 3> place = {rule.points[i], rule.points[j],
                                             axes == 3 ? rule.points[k] : 0};
        shape.points.push_back(at_point(axes, place, weight));
      }
    }
  }
  return shape;
}

}  // namespace

const ElementShape& hexahedron() {
  static const ElementShape shape = made(3, 3);
  return shape;
}

const ElementShape& quadrilateral() {
  static const ElementShape shape = made(2, 4);
  return shape;
}

}  // namespace latticast
