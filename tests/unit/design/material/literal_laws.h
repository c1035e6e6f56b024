// SPDX-License-Identifier: GPL-3.0-or-later
// Strain energies as their authors wrote them, in principal stretches: what the laws of
// design/material are compared with.
#pragma once

#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "design/material/law.h"

namespace latticast::testing {

using Stretches = std::array<long double, 3>;

inline long double sum_of_powers(const Stretches& stretches, long double exponent) {
  long double sum = 0;
  for (const long double stretch : stretches) sum += std::pow(stretch, exponent);
  return sum;
}

struct LiteralEnergy {
  Stretches stretches;

  long double first_invariant() const { return sum_of_powers(stretches, 2) - 3; }

  long double operator()(const Linear& law) const {
    return law.youngs_modulus_mpa / 6.0L * first_invariant();
  }
  long double operator()(const NeoHookean& law) const {
    return law.shear_modulus_mpa / 2.0L * first_invariant();
  }
  long double operator()(const Yeoh& law) const {
    const long double j = first_invariant();
    return law.c1_mpa * j + law.c2_mpa * j * j + law.c3_mpa * j * j * j;
  }
  long double operator()(const Gent& law) const {
    const long double limit = law.limit_jm;
    return -law.shear_modulus_mpa * limit / 2 * std::log(1 - first_invariant() / limit);
  }
  long double operator()(const Mooney& law) const {
    return law.c10_mpa * first_invariant() + law.c01_mpa * (sum_of_powers(stretches, -2) - 3);
  }
  long double operator()(const Ogden& law) const {
    long double sum = 0;
    for (std::size_t p = 0; p < law.alpha.size(); ++p) {
      sum += law.mu_mpa[p] / static_cast<long double>(law.alpha[p]) *
             (sum_of_powers(stretches, law.alpha[p]) - 3);
    }
    return sum;
  }
};

/// In MPa. Precondition: the product of the stretches is 1.
inline long double literal_energy(const Law& law, const Stretches& stretches) {
  return std::visit(LiteralEnergy{stretches}, law);
}

/// At least one of every rubber, single terms of either sign included where the law has several.
inline std::vector<Law> example_rubbers() {
  return {NeoHookean{0.08}, Yeoh{0.04, -0.002, 0.0003}, Gent{0.08, 12}, Mooney{0.03, 0.01},
          Mooney{0.05, -0.005},
          // The three terms of [Ogden 1972] for Treloar's rubber, and single ones.
          Ogden{{0.63, 0.0012, -0.01}, {1.3, 5, -2}}, Ogden{{0.02}, {4}}, Ogden{{-0.1}, {-3}},
          Ogden{{0.01, -0.3}, {11.5, -0.2}}};
}

/// Constants that must be refused, and a word that the reason must hold.
struct FaultyLaw {
  Law law;
  const char* reason;
};

inline std::vector<FaultyLaw> faulty_laws() {
  return {
      {NeoHookean{-0.08}, "modulus at rest"},      {Yeoh{-0.04, 1, 1}, "modulus at rest"},
      {Mooney{0.03, -0.03}, "modulus at rest"},    {Ogden{{0.08}, {-2}}, "modulus at rest"},
      {Ogden{{0.08, 0.01}, {2}}, "of one length"}, {Ogden{{0.08, 0.01}, {2, 0}}, "away from 0"}};
}

}  // namespace latticast::testing
