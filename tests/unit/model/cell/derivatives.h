// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of an element's energy and of a bore's face against differences.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <gtest/gtest.h>

#include "model/cell/element_energy.h"
#include "tests/random_numbers.h"

namespace latticast::testing {

template <std::size_t N>
using Components = std::array<std::array<double, 3>, N>;

template <std::size_t N>
Components<N> random_components(Random& random, double size) {
  Components<N> u{};
  for (auto& node : u) {
    for (double& x : node) x = random.between(-size, size);
  }
  return u;
}

inline constexpr TubeStrain strain = {0.1, 0.01, 0.002, -0.003};

template <std::size_t N, class Evaluate>
void expect_derivatives(const Components<N>& u, const Evaluate& evaluated, double scale) {
  using Part = std::decay_t<decltype(evaluated(u, strain))>;
  constexpr int unknowns = 3 * N;
  constexpr double step = 1e-5;
  const Part at = evaluated(u, strain);
  for (int k = 0; k < Part::size; ++k) {
    Components<N> ahead = u;
    Components<N> behind = u;
    TubeStrain ahead_strain = strain;
    TubeStrain behind_strain = strain;
    (k < unknowns ? ahead[k / 3][k % 3] : ahead_strain[k - unknowns]) += step;
    (k < unknowns ? behind[k / 3][k % 3] : behind_strain[k - unknowns]) -= step;
    const Part a = evaluated(ahead, ahead_strain);
    const Part b = evaluated(behind, behind_strain);
    for (int i = 0; i <= k; ++i) {
      const double expected = at.hessian[i * Part::size + k];
      EXPECT_NEAR((a.gradient[i] - b.gradient[i]) / (2 * step), expected,
                  1e-7 * (scale + std::abs(expected)))
          << i << ' ' << k;
    }
  }
}

/// Displacement of one deformation gradient everywhere, along a node's own directions.
inline std::array<double, 3> uniform_gradient(const CellNode& node) {
  constexpr double g[3][3] = {{0.08, 0.03, -0.02}, {-0.05, 0.1, 0.04}, {0.06, -0.03, -0.07}};
  const double c = std::cos(node.angle_rad);
  const double s = std::sin(node.angle_rad);
  const double place[3] = {node.radius_mm * c, node.radius_mm * s, node.height_mm};
  double moved[3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) moved[i] += g[i][j] * place[j];
  }
  return {c * moved[0] + s * moved[1], c * moved[1] - s * moved[0], moved[2]};
}

}  // namespace latticast::testing
