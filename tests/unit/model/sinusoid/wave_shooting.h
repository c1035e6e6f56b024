// SPDX-License-Identifier: GPL-3.0-or-later
// The pulled half wave as an initial-value problem along its phase, in long double: independent of
// how the model solves it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/sinusoid/wave_equilibrium.h"

namespace latticast {

struct WaveShot {
  long double end_moment = 0;  ///< theta' - kappa0 where the wave crosses its chord line
  long double quarter_chord = 0;
  long double quarter_energy = 0;  ///< over E I/(c/pi)
};

/// Integrates theta' = kappa0 + m, m' = beta sin(theta)(1 + delta cos(theta)) from the crest, where
/// theta = 0 and m = `crest_moment`, by Gragg's modified midpoint rule with Richardson
/// extrapolation on each of `intervals` intervals of the phase.
inline WaveShot shoot(const Wave& wave, long double beta, long double crest_moment, int intervals) {
  using Values = std::array<long double, 4>;  // theta, m, chord, energy
  constexpr int columns = 8;
  const long double a = wave.slope;
  const long double delta = beta * wave.compliance;
  const auto rates = [&](long double x, const Values& v) {
    const long double slope = a * std::sin(x);
    const long double speed = std::sqrt(1 + slope * slope);
    const long double curvature = a * std::cos(x) / (speed * speed * speed);
    const long double sine = std::sin(v[0]);
    const long double cosine = std::cos(v[0]);
    return Values{speed * (curvature + v[1]), speed * beta * sine * (1 + delta * cosine),
                  speed * cosine * (1 + delta * cosine),
                  speed * (v[1] * v[1] + delta * beta * cosine * cosine) / 2};
  };
  const auto along = [](const Values& v, long double by, const Values& rate) {
    Values next = v;
    for (std::size_t i = 0; i < 4; ++i) next[i] += by * rate[i];
    return next;
  };
  const auto midpoint = [&](long double x, const Values& start, long double length, int steps) {
    const long double h = length / steps;
    Values before = start;
    Values here = along(start, h, rates(x, start));
    for (int i = 1; i < steps; ++i) {
      const Values next = along(before, 2 * h, rates(x + i * h, here));
      before = here;
      here = next;
    }
    const Values last = along(before, h, rates(x + length, here));
    Values mean{};
    for (std::size_t i = 0; i < 4; ++i) mean[i] = (here[i] + last[i]) / 2;
    return mean;
  };
  const long double length = std::numbers::pi_v<long double> / 2 / intervals;
  Values v{0, crest_moment, 0, 0};
  for (int n = 0; n < intervals; ++n) {
    std::array<Values, columns> table{};
    for (int j = 0; j < columns; ++j) {
      Values before = table[0];
      table[0] = midpoint(n * length, v, length, 2 * (j + 1));
      for (int k = 1; k <= j; ++k) {
        const long double ratio = static_cast<long double>(j + 1) / (j + 1 - k);
        const Values finer = table[k - 1];
        Values better{};
        for (std::size_t i = 0; i < 4; ++i) {
          better[i] = finer[i] + (finer[i] - before[i]) / (ratio * ratio - 1);
        }
        before = table[k];
        table[k] = better;
      }
    }
    v = table[columns - 1];
  }
  return {v[1], v[2], v[3]};
}

/// The wave without moment at its end, by secant steps on the moment at its crest.
inline WaveShot shoot_free_end(const Wave& wave, long double beta, long double crest_moment,
                               int intervals) {
  long double before = crest_moment;
  long double here = crest_moment * (1 + 1e-5L);
  WaveShot last = shoot(wave, beta, before, intervals);
  WaveShot shot = shoot(wave, beta, here, intervals);
  for (int i = 0; i < 20 && shot.end_moment != last.end_moment; ++i) {
    const long double next =
        here - shot.end_moment * (here - before) / (shot.end_moment - last.end_moment);
    if (std::abs(next - here) <= 1e-17L * std::abs(here)) break;
    before = here;
    last = shot;
    here = next;
    shot = shoot(wave, beta, here, intervals);
  }
  return shot;
}

}  // namespace latticast
