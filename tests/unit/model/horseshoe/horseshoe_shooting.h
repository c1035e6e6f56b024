// SPDX-License-Identifier: GPL-3.0-or-later
// The pulled arc as an initial-value problem, in long double: independent of how the model solves
// it.
#pragma once

#include <array>
#include <cmath>

#include "model/horseshoe/arc_integrals.h"

namespace latticast {

struct Shot {
  long double end_slope = 0;    ///< theta(phi0)
  long double end_rate = 0;     ///< theta'(phi0)
  long double half_chord = 0;   ///< over R
  long double half_energy = 0;  ///< strain energy of half an arc, over E I/R
  long double drift = 0;        ///< largest change of the invariant on the way
};

/// Integrates theta'' = beta sin(theta)(1 + delta cos(theta)) from theta = 0, theta' =
/// exp(log_rate) by Taylor series of order 22. Errors are relative to theta, so tiny starting rates
/// are no trouble.
inline Shot shoot(const Arc& arc, double force, long double log_rate) {
  constexpr int order = 22;
  using Terms = std::array<long double, order + 1>;
  const long double beta = force;
  const long double delta = beta * arc.compliance;
  const long double growth = std::sqrt(std::abs(beta) * (1 + std::abs(delta))) + 1;
  const long steps = static_cast<long>(std::ceil(arc.half_angle_rad * growth / 0.4L));
  const long double step = static_cast<long double>(arc.half_angle_rad) / steps;

  const auto invariant = [&](long double theta, long double rate) {
    const long double half_sine = std::sin(theta / 2);
    const long double z = half_sine * half_sine;
    return rate * rate - 4 * beta * z * (1 + delta * (1 - z));
  };
  Shot shot;
  long double rate = std::exp(log_rate);
  const long double start = invariant(0, rate);
  for (long n = 0; n < steps; ++n) {
    Terms theta{};
    Terms sine{};
    Terms cosine{};
    Terms chord{};
    Terms energy{};
    theta[0] = shot.end_slope;
    theta[1] = rate;
    sine[0] = std::sin(theta[0]);
    cosine[0] = std::cos(theta[0]);
    for (int k = 0; k <= order; ++k) {
      for (int j = 1; j <= k; ++j) {
        sine[k] += j * theta[j] * cosine[k - j] / k;
        cosine[k] -= j * theta[j] * sine[k - j] / k;
      }
      long double sine_cosine = 0;
      long double cosine_squared = 0;
      long double bending = 0;
      for (int j = 0; j <= k; ++j) {
        sine_cosine += sine[j] * cosine[k - j];
        cosine_squared += cosine[j] * cosine[k - j];
      }
      if (k + 2 <= order) {
        theta[k + 2] = beta * (sine[k] + delta * sine_cosine) / ((k + 1.0L) * (k + 2));
      }
      const auto curvature = [&theta](int j) {
        return j < order ? (j + 1) * theta[j + 1] - (j == 0 ? 1 : 0) : 0.0L;
      };
      for (int j = 0; j <= k; ++j) bending += curvature(j) * curvature(k - j);
      if (k < order) {
        chord[k + 1] = (cosine[k] + delta * cosine_squared) / (k + 1);
        energy[k + 1] = (bending + delta * beta * cosine_squared) / 2 / (k + 1);
      }
    }
    long double next_theta = 0;
    long double next_rate = 0;
    for (int k = order; k >= 0; --k) {
      next_theta = next_theta * step + theta[k];
      if (k > 0) next_rate = next_rate * step + k * theta[k];
    }
    long double chord_step = 0;
    long double energy_step = 0;
    for (int k = order; k >= 0; --k) {
      chord_step = chord_step * step + chord[k];
      energy_step = energy_step * step + energy[k];
    }
    shot.half_chord += chord_step;
    shot.half_energy += energy_step;
    shot.end_slope = next_theta;
    rate = next_rate;
    shot.drift = std::max(shot.drift, std::abs(invariant(shot.end_slope, rate) - start));
  }
  shot.end_rate = rate;
  return shot;
}

/// The arc without moment at its end, theta'(phi0) = 1, by secant steps on the logarithms of the
/// starting rate and the end's. `end_slope_rad` is where the search begins.
inline Shot shoot_free_end(const Arc& arc, double force, double end_slope_rad) {
  const long double delta = static_cast<long double>(force) * arc.compliance;
  const long double z = std::pow(std::sin(end_slope_rad / 2.0L), 2);
  const long double start = 1 - 4 * force * z * (1 + delta * (1 - z));
  // A start that is small is a difference of large numbers; then the arc is nearly straight.
  const long double growth = std::sqrt(std::abs(force * (1 + delta))) * arc.half_angle_rad;
  long double log_rate =
      start > 0.01L ? std::log(start) / 2 : -(growth + std::log((1 + std::exp(-2 * growth)) / 2));
  long double response = 1;
  Shot shot = shoot(arc, force, log_rate);
  for (int i = 0; i < 12 && std::abs(std::log(shot.end_rate)) > 1e-15L; ++i) {
    const long double before = std::log(shot.end_rate);
    const long double change = -before / response;
    log_rate += change;
    shot = shoot(arc, force, log_rate);
    const long double measured = (std::log(shot.end_rate) - before) / change;
    if (std::isfinite(measured) && std::abs(before) > 1e-12L) response = measured;
  }
  return shot;
}

}  // namespace latticast
