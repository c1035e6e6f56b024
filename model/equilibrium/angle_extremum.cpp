// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/angle_extremum.h"

#include <algorithm>
#include <cmath>

#include "model/equilibrium/step_control.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr double least_angle = 1e-9;  // scaled, above rounding
constexpr double accuracy = 1e-11;    // of a rate, against its change over the step
constexpr double least_share = 1e-3;  // of the bracket, between a search's next place and its ends
constexpr int most_halvings = 6;
constexpr int most_extremum_searches = 80;

/// One angle by the entries of a point that make it: `count` successive ones, two for a bending
/// about any axis.
struct Angle {
  bool of_bending = false;
  int first = 0;
  int count = 0;

  double size(const BranchPoint& x) const {
    return count == 1 ? std::abs(x[first]) : std::hypot(x[first], x[first + 1]);
  }

  /// Slope along the branch: of the signed angle where it has one entry, else of its size.
  double rate(const BranchState& state) const {
    const double angle = size(state.x);
    const double speed = size(state.tangent);
    if (angle < least_angle && speed < least_angle) return 0;
    if (count == 1) return state.tangent[first];
    if (angle < least_angle) return speed;
    return (state.x[first] * state.tangent[first] + state.x[first + 1] * state.tangent[first + 1]) /
           angle;
  }

  double mean_rate(const BranchState& from, const BranchState& to) const {
    const double change = count == 1 ? to.x[first] - from.x[first] : size(to.x) - size(from.x);
    return change / distance(from.x, to.x);
  }
};

Angle angle_of(const Balance& balance, bool bending) {
  Angle angle{bending};
  const std::vector<int>& free = balance.free_coordinates();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const bool bend = free[i] == coordinate::bend_1 || free[i] == coordinate::bend_2;
    if (bending ? !bend : free[i] != coordinate::twist) continue;
    if (angle.count == 0) angle.first = static_cast<int>(i);
    ++angle.count;
  }
  return angle;
}

/// Where the rate is zero, its signs at the ends being different. Empty where the rate jumps
/// instead.
std::optional<ExtremumState> located(const Angle& angle, int pressure_entry,
                                     const BranchState& from, const BranchState& to,
                                     const EquilibriumNear& equilibrium) {
  BranchPoint low = from.x;
  BranchPoint high = to.x;
  const double at_low = angle.rate(from);
  const double at_high = angle.rate(to);
  const double sense = at_low > 0 ? 1 : -1;
  const double size = std::abs(at_low - at_high);
  const double step = std::abs(high[pressure_entry] - low[pressure_entry]);
  RootSearch search(low[pressure_entry], at_low, high[pressure_entry], at_high);
  for (int i = 0; i < most_extremum_searches; ++i) {
    const double load = search.next(least_share);
    const double fraction =
        (load - low[pressure_entry]) / (high[pressure_entry] - low[pressure_entry]);
    const auto middle = equilibrium(at_load(between(low, high, fraction), load, pressure_entry));
    if (!middle) return std::nullopt;
    const double rate = angle.rate(*middle);
    const double pressure = std::abs(middle->x[pressure_entry]);
    const bool narrow = search.width() < 1e-13 * pressure;
    if (std::abs(rate) < accuracy * size || narrow) {
      if (std::abs(rate) > 1e-3 * size) return std::nullopt;
      const bool outward = angle.count > 1 || middle->x[angle.first] > 0;
      const double error = std::abs(rate) / size * step / pressure;
      return ExtremumState{angle.of_bending, (sense > 0) == outward, middle->x, middle->balance,
                           error};
    }
    (rate * sense > 0 ? low : high) = middle->x;
    search.narrow(load, rate);
  }
  return std::nullopt;
}

void search(const Angle& angle, int pressure_entry, const BranchState& from, const BranchState& to,
            const EquilibriumNear& equilibrium, int halvings, std::vector<ExtremumState>& found) {
  const double start = angle.rate(from);
  const double end = angle.rate(to);
  if (start * end < 0) {
    const auto turning = located(angle, pressure_entry, from, to, equilibrium);
    if (turning) found.push_back(*turning);
    return;
  }
  if (halvings == 0 || !slope_may_vanish(start, end, angle.mean_rate(from, to))) return;
  const auto middle = equilibrium(between(from.x, to.x, 0.5));
  if (!middle) return;
  search(angle, pressure_entry, from, *middle, equilibrium, halvings - 1, found);
  search(angle, pressure_entry, *middle, to, equilibrium, halvings - 1, found);
}

}  // namespace

std::vector<ExtremumState> angle_extrema_between(const Balance& balance, const BranchState& from,
                                                 const BranchState& to,
                                                 const EquilibriumNear& equilibrium) {
  std::vector<ExtremumState> found;
  for (const bool bending : {true, false}) {
    const Angle angle = angle_of(balance, bending);
    if (angle.count == 0) continue;
    search(angle, balance.free_count(), from, to, equilibrium, most_halvings, found);
  }
  std::stable_sort(found.begin(), found.end(), [&](const ExtremumState& a, const ExtremumState& b) {
    const int n = balance.free_count();
    return std::abs(a.x[n]) < std::abs(b.x[n]);
  });
  return found;
}

}  // namespace latticast
