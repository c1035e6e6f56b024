// SPDX-License-Identifier: GPL-3.0-or-later
// Incompressible Ogden rubber, W = sum over p of mu_p/alpha_p (lambda_1^alpha_p + lambda_2^alpha_p
// + lambda_3^alpha_p - 3) [Ogden 1972]; docs/materials.md#ogden-where-stretches-coincide.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "design/material/in_plane_stretch.h"
#include "design/material/law_key.h"

namespace latticast {

namespace ogden {

inline constexpr double series_below = 0.1;  // above, the closed form loses less than two digits
inline constexpr int most_terms = 100;

/// A function of one number with two derivatives.
struct Curve {
  double value = 0;
  double slope = 0;
  double curvature = 0;
};

/// cosh(alpha asinh(sqrt z)) - 1 as a power series in z: each coefficient is
/// the one before times (alpha^2 - 4 n^2)/((n + 1)(4 n + 2)).
inline Curve parting_series(double alpha, double z) {
  double coefficient = 0.5 * alpha * alpha;
  Curve sum{coefficient * z, coefficient, 0};
  double power = 1;  // z^(n - 2)
  for (int n = 2; n < most_terms; ++n) {
    const double before = n - 1;
    coefficient *= (alpha * alpha - 4 * before * before) / (n * (4 * before + 2));
    const double term = coefficient * power;
    sum.value += term * z * z;
    sum.slope += n * term * z;
    sum.curvature += n * before * term;
    if (std::abs(n * before * term) <= 1e-18 * std::abs(sum.curvature)) break;
    power *= z;
  }
  return sum;
}

/// cosh(alpha theta) - 1 by z = sinh^2(theta), theta being half of
/// ln(lambda_1/lambda_2).
inline Curve parting(double alpha, double z) {
  if (z < series_below) return parting_series(alpha, z);
  const double theta = std::asinh(std::sqrt(z));
  const double half = std::sinh(0.5 * alpha * theta);
  Curve g;
  g.value = 2 * half * half;
  g.slope = alpha * std::sinh(alpha * theta) / std::sinh(2 * theta);
  g.curvature = (alpha * alpha * (1 + g.value) - 2 * (1 + 2 * z) * g.slope) / (4 * z * (1 + z));
  return g;
}

/// lambda_1^alpha + lambda_2^alpha + lambda_3^alpha - 3: what equal stretches
/// in the plane give, and what they give more when they part.
inline EnergyDensity power_sum_minus_3(double alpha, const InPlaneStretch& at) {
  const double s = 1 + at.area;
  const double e = std::expm1(0.5 * alpha * std::log1p(at.area));
  const double p = 1 + e;  // s^(alpha/2)
  const double z = 0.25 * at.distortion / s;
  const Curve g = parting(alpha, z);
  const double by_s = alpha * g.value - 2 * z * g.slope;  // times p/s
  const double by_s_by_z = (alpha - 2) * g.slope - 2 * z * g.curvature;
  return {.value = e * e * (3 + 2 * e) / (p * p) + 2 * p * g.value,
          .by_area = alpha / s * e * (3 + e * (3 + e)) / (p * p) + p / s * by_s,
          .by_distortion = 0.5 * p / s * g.slope,
          .by_area_area = alpha / (s * s) * ((0.5 * alpha - 1) * p + (alpha + 1) / (p * p)) +
                          p / (s * s) * ((0.5 * alpha - 1) * by_s - z * by_s_by_z),
          .by_area_distortion = 0.25 * p / (s * s) * by_s_by_z,
          .by_distortion_distortion = 0.125 * p / (s * s) * g.curvature};
}

}  // namespace ogden

/// Lists of one length, 1 to 10. Shear modulus at rest: half of the sum of
/// mu_p alpha_p.
struct Ogden {
  std::vector<double> mu_mpa;
  std::vector<double> alpha;

  static constexpr std::string_view name = "ogden";
  static constexpr LawKey<Ogden> keys[] = {
      {"mu", "mu = [0.08]", signed_modulus_range, &Ogden::mu_mpa},
      {"alpha", "alpha = [2]", {.low = -50, .high = 50}, &Ogden::alpha}};

  double rest_shear_modulus_mpa() const;
  double first_invariant_limit() const { return std::numeric_limits<double>::infinity(); }
  EnergyDensity energy_density(const InPlaneStretch& at) const;
  std::string_view fault() const;

  friend bool operator==(const Ogden&, const Ogden&) = default;
};

inline double Ogden::rest_shear_modulus_mpa() const {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(mu_mpa.size(), alpha.size()); ++i) {
    sum += mu_mpa[i] * alpha[i];
  }
  return 0.5 * sum;
}

inline EnergyDensity Ogden::energy_density(const InPlaneStretch& at) const {
  EnergyDensity sum;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    sum = sum + mu_mpa[i] / alpha[i] * ogden::power_sum_minus_3(alpha[i], at);
  }
  return sum;
}

inline std::string_view Ogden::fault() const {
  if (mu_mpa.empty() || alpha.empty()) return "";
  if (mu_mpa.size() != alpha.size()) return "its lists mu and alpha must be of one length";
  for (const double exponent : alpha) {
    if (std::abs(exponent) < 1e-3) return "each alpha must be 0.001 or more away from 0";
  }
  return "";
}

}  // namespace latticast
