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

}  // namespace latticast::testing
