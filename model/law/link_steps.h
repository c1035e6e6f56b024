// SPDX-License-Identifier: GPL-3.0-or-later
// Natural continuation of a link's equilibria in the strain of its chord: a prediction and a Newton
// correction per step, halved where the correction fails or leads away, doubled where it does not.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

namespace latticast {

/// A correction that is larger, against what it corrects, may have found another branch.
inline constexpr double largest_correction = 0.3;

/// Relative size of a Newton step after which one more is the last: convergence being quadratic,
/// the derivatives there are good to about 1e-12 and the equilibrium to rounding.
inline constexpr double small_step = 1e-6;

/// The equilibrium at `strain`. `step(here, next)` gives the one at the strain `next` from that at
/// `here.strain`, or nothing where it is too far. Empty where steps of 1e-6 of the way fail.
template <class Equilibrium, class Step>
std::optional<Equilibrium> advance_link(const Equilibrium& from, double strain, Step&& step) {
  constexpr double shortest_step = 1e-6;  // of the way asked for
  Equilibrium here = from;
  double ahead = strain - from.strain;
  const double shortest = shortest_step * std::abs(ahead);
  while (here.strain != strain) {
    const double left = strain - here.strain;
    const double next = std::abs(ahead) < std::abs(left) ? here.strain + ahead : strain;
    const double length = next - here.strain;
    if (std::optional<Equilibrium> found = step(here, next)) {
      here = std::move(*found);
      ahead = 2 * length;
    } else {
      ahead = length / 2;
      if (!(std::abs(ahead) >= shortest)) return {};
    }
  }
  return here;
}

}  // namespace latticast
