// SPDX-License-Identifier: GPL-3.0-or-later
// Against differences, rotations, and the laws' own energies of an incompressible sheet.
#include "model/cell/point_energy.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/random_numbers.h"

namespace latticast::testing {
namespace {

const std::vector<Law> laws = {Linear{0.3, 0.5},          NeoHookean{0.08},
                               Yeoh{0.03, 0.002, 0.0001}, Gent{0.08, 60},
                               Mooney{0.03, 0.01},        Ogden{{0.05, -0.01}, {1.3, -3}}};

const Tensor rest = {1, 0, 0, 0, 1, 0, 0, 0, 1};
const Tensor equibiaxial = {1.3, 0, 0, 0, 1.3, 0, 0, 0, 0.7};

Tensor random_gradient(Random& random) {
  Tensor f = rest;
  for (double& x : f) x += random.between(-0.3, 0.3);
  return f;
}

Tensor product(const Tensor& a, const Tensor& b) {
  Tensor c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    }
  }
  return c;
}

void expect_derivatives(const Law& law, const Tensor& f) {
  constexpr double step = 1e-6;
  const auto at = isochoric_energy(law, f);
  ASSERT_TRUE(at);
  for (std::size_t k = 0; k < 9; ++k) {
    Tensor ahead = f;
    Tensor behind = f;
    ahead[k] += step;
    behind[k] -= step;
    const auto a = isochoric_energy(law, ahead);
    const auto b = isochoric_energy(law, behind);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR((a->energy - b->energy) / (2 * step), at->stress[k], 1e-9);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR((a->stress[i] - b->stress[i]) / (2 * step), at->tangent[9 * i + k], 1e-8)
          << law_name(law) << ' ' << i << ' ' << k;
      EXPECT_NEAR(at->tangent[9 * i + k], at->tangent[9 * k + i], 1e-15);
    }
  }
}

TEST(PointEnergy, HasItsDerivatives) {
  Random random(1);
  for (const Law& law : laws) {
    for (int i = 0; i < 10; ++i) expect_derivatives(law, random_gradient(random));
  }
}

TEST(PointEnergy, HasThemWhereStretchesCoincide) {
  for (const Law& law : laws) {
    expect_derivatives(law, rest);
    expect_derivatives(law, equibiaxial);
  }
}

TEST(PointEnergy, IsThatOfAnIncompressibleSheet) {
  Random random(2);
  for (const Law& law : laws) {
    const double first = random.between(0.7, 1.6);
    const double second = random.between(0.7, 1.6);
    const Tensor f = {first, 0, 0, 0, 1 / (first * second), 0, 0, 0, second};
    const double expected =
        energy_density(law, {first * second - 1, std::pow(first - second, 2)}).value;
    EXPECT_NEAR(isochoric_energy(law, f)->energy, expected, 1e-15);
  }
}

TEST(PointEnergy, KnowsNeitherRotationNorVolume) {
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Tensor turn = {c, -s, 0, s * c, c * c, -s, s * s, s * c, c};
  Random random(3);
  for (const Law& law : laws) {
    const Tensor f = random_gradient(random);
    const double energy = isochoric_energy(law, f)->energy;
    EXPECT_NEAR(isochoric_energy(law, product(turn, f))->energy, energy, 1e-15);
    EXPECT_NEAR(isochoric_energy(law, product(f, turn))->energy, energy, 1e-15);
    Tensor blown = f;
    for (double& x : blown) x *= 1.4;
    EXPECT_NEAR(isochoric_energy(law, blown)->energy, energy, 1e-15);
  }
}

TEST(PointEnergy, IsEmptyWhereAPointCannotBe) {
  EXPECT_FALSE(isochoric_energy(NeoHookean{0.08}, {1, 0, 0, 0, 1, 0, 0, 0, -1}));
  EXPECT_FALSE(isochoric_energy(Ogden{{0.08}, {2}}, {1, 0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(isochoric_energy(Gent{0.08, 3}, {4, 0, 0, 0, 1, 0, 0, 0, 0.25}));
}

}  // namespace
}  // namespace latticast::testing
