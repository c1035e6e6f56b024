// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/element_shape.h"

#include <cmath>
#include <utility>

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

/// The triangle's seven functions: the quadratic ones, each less its value at the centre times the
/// bubble 27 L0 L1 L2.
struct TriangleFunctions {
  std::array<double, 7> value;
  std::array<std::array<double, 2>, 7> slope;

  TriangleFunctions(double x, double y) {
    const std::array<double, 3> l = {1 - x - y, x, y};
    constexpr std::array<std::array<double, 2>, 3> by = {{{-1, -1}, {1, 0}, {0, 1}}};
    const double bubble = 27 * l[0] * l[1] * l[2];
    std::array<double, 2> bubble_slope{};
    for (std::size_t a = 0; a < 2; ++a) {
      bubble_slope[a] =
          27 * (by[0][a] * l[1] * l[2] + l[0] * by[1][a] * l[2] + l[0] * l[1] * by[2][a]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      value[i] = l[i] * (2 * l[i] - 1) + bubble / 9;
      value[3 + i] = 4 * l[i] * l[j] - 4 * bubble / 9;
      for (std::size_t a = 0; a < 2; ++a) {
        slope[i][a] = (4 * l[i] - 1) * by[i][a] + bubble_slope[a] / 9;
        slope[3 + i][a] = 4 * (by[i][a] * l[j] + l[i] * by[j][a]) - 4 * bubble_slope[a] / 9;
      }
    }
    value[6] = bubble;
    slope[6] = bubble_slope;
  }
};

struct TrianglePoint {
  double x = 0;
  double y = 0;
  double weight = 0;  // of an area of 1/2
};

constexpr double third = 1.0 / 3;

/// The middle and two orbits of three points, exact to the fifth order [Radon 1948].
std::vector<TrianglePoint> seven_points() {
  const double root = std::sqrt(15.0);
  std::vector<TrianglePoint> points = {{third, third, 9.0 / 80}};
  for (const double sign : {1.0, -1.0}) {
    const double a = (6 + sign * root) / 21;
    const double weight = (155 + sign * root) / 2400;
    const double b = 1 - 2 * a;
    for (const auto& [x, y] : {std::pair{a, a}, std::pair{b, a}, std::pair{a, b}}) {
      points.push_back({x, y, weight});
    }
  }
  return points;
}

/// A square's rule with one side drawn together into a corner.
std::vector<TrianglePoint> collapsed_points(int count) {
  const GaussRule rule = gauss_legendre(count);
  std::vector<TrianglePoint> points;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
      const double x = 0.5 * (1 + rule.points[i]);
      const double y = 0.5 * (1 + rule.points[j]) * (1 - x);
      points.push_back({x, y, 0.25 * rule.weights[i] * rule.weights[j] * (1 - x)});
    }
  }
  return points;
}

ElementShape made_triangle() {
  ElementShape shape{.nodes = 7, .points = {}};
  for (const TrianglePoint& at : collapsed_points(4)) {
    const TriangleFunctions functions(at.x, at.y);
    ShapeAtPoint point{
        .weight = at.weight, .place = {at.x - third, at.y - third, 0}, .value = {}, .slope = {}};
    for (std::size_t p = 0; p < 7; ++p) {
      point.value.push_back(functions.value[p]);
      point.slope.push_back({functions.slope[p][0], functions.slope[p][1], 0});
    }
    shape.points.push_back(std::move(point));
  }
  return shape;
}

ElementShape made_wedge() {
  ElementShape shape{.nodes = 21, .points = {}};
  const GaussRule rule = gauss_legendre(3);
  for (std::size_t g = 0; g < rule.points.size(); ++g) {
    const Parabolas through(rule.points[g]);
    for (const TrianglePoint& at : seven_points()) {
      const TriangleFunctions functions(at.x, at.y);
      ShapeAtPoint point{.weight = at.weight * rule.weights[g],
                         .place = {at.x - third, at.y - third, rule.points[g]},
                         .value = {},
                         .slope = {}};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t p = 0; p < 7; ++p) {
          point.value.push_back(functions.value[p] * through.value[k]);
          point.slope.push_back({functions.slope[p][0] * through.value[k],
                                 functions.slope[p][1] * through.value[k],
                                 functions.value[p] * through.slope[k]});
        }
      }
      shape.points.push_back(std::move(point));
    }
  }
  return shape;
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

const ElementShape& wedge() {
  static const ElementShape shape = made_wedge();
  return shape;
}

const ElementShape& quadrilateral() {
  static const ElementShape shape = made(2, 4);
  return shape;
}

const ElementShape& triangle() {
  static const ElementShape shape = made_triangle();
  return shape;
}

}  // namespace latticast
