// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of a section written out once more for the tests: all five coordinates, a fine
// quadrature around the whole tube, no symmetry used, elimination by hand.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "model/section/section_energy.h"

namespace latticast::testing {

using FullVector = std::vector<double>;
using FullMatrix = std::vector<std::vector<double>>;

/// Gaussian elimination with row pivoting.
inline FullVector solve_linear(FullMatrix a, FullVector b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < n; ++r) {
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    }
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t r = i + 1; r < n; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < n; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) b[i] -= a[i][c] * b[c];
    b[i] /= a[i][i];
  }
  return b;
}

/// Whether a symmetric matrix is positive definite: all pivots of an elimination without swaps are.
inline bool positive_definite(FullMatrix a) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i][i] > 0)) return false;
    for (std::size_t r = i + 1; r < a.size(); ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < a.size(); ++c) a[r][c] -= factor * a[i][c];
    }
  }
  return true;
}

/// Imbalance dPi/dq and stiffness d2Pi/dq2 over the coordinates that are not fixed, scaled to
/// (lambda, k R_o, a/R_i, kappa R_o).
struct FullBalance {
  FullVector imbalance;
  FullMatrix stiffness;
};

inline std::optional<FullBalance> full_balance(const Section& section, const Quadrature& quadrature,
                                               const Deformation& q, double pressure_mpa,
                                               const std::array<bool, 5>& fixed = {}) {
  const auto energy = stored_energy(section, quadrature, q);
  if (!energy) return std::nullopt;
  const SectionEnergy cavity = cavity_growth(section, q);
  const double outer = section.outer_radius_mm;
  const std::array<double, 5> scale = {1, 1 / outer, section.inner_radius_mm, 1 / outer, 1 / outer};
  FullBalance balance;
  for (int i = 0; i < 5; ++i) {
    if (fixed[i]) continue;
    balance.imbalance.push_back((energy->gradient[i] - pressure_mpa * cavity.gradient[i]) *
                                scale[i]);
    balance.stiffness.emplace_back();
    for (int j = 0; j < 5; ++j) {
      if (fixed[j]) continue;
      balance.stiffness.back().push_back(
          (energy->second(i, j) - pressure_mpa * cavity.second(i, j)) * scale[i] * scale[j]);
    }
  }
  return balance;
}

/// The Newton step that a state still lacks: its error, largest entry.
inline double missing_step(const FullBalance& balance) {
  double largest = 0;
  for (const double step : solve_linear(balance.stiffness, balance.imbalance)) {
    largest = std::max(largest, std::abs(step));
  }
  return largest;
}

}  // namespace latticast::testing
