// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/effective_rods/rods_response.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "design/units.h"
#include "model/equilibrium/branch_text.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr int scan_steps = 64;

std::optional<RodsState> at_pressure(const Rods& rods, double pressure_kpa, Held held,
                                     RodsRefusal* why = nullptr) {
  return rods_equilibrium(rods, {mpa_from_kpa(pressure_kpa), 0, 0, held.stretch, held.bend}, why);
}

std::string refusal_text(const Rods& rods, double pressure_kpa, RodsRefusal why) {
  const std::string at = "at " + pressure_text(pressure_kpa);
  if (why == RodsRefusal::no_length) {
    return at + " a side of the wall would be compressed to no length at all";
  }
  const StrandLaws laws = laws_of(rods);
  return at + " a " + std::string(path_name(laws.front()->shape())) +
         " column would leave its law's range of strain";
}

State state_of(const Rods& rods, const RodsState& found, double pressure_kpa) {
  State state;
  state.pressure_kpa = pressure_kpa;
  state.stretch = 1 + found.elongation;
  state.bend_rad_per_mm = {0, found.bend_rad_per_mm};
  state.inner_radius_mm = rods.inner_radius_mm;
  state.outer_radius_mm =
      current_radius_mm(rods.inner_radius_mm, rods.outer_radius_mm, {found.elongation});
  state.moment_nmm = {0, found.moment_nmm};
  state.force_n = found.force_n;
  state.residual = found.residual;
  state.error_estimate = found.error;
  state.smallest_eigenvalue = found.smallest_eigenvalue;
  state.stable = found.smallest_eigenvalue > 0;
  state.iterations = found.iterations;
  return state;
}

/// The pressure between two, d|kappa|/dP having opposite signs there, where it is zero.
AngleExtremum extremum_between(const Rods& rods, double length_mm, double low_kpa, double high_kpa,
                               const RodsState& at_low) {
  const auto rate = [&](double pressure_kpa) {
    return at_pressure(rods, pressure_kpa, {})->bend_rad_per_mm_per_mpa;
  };
  AngleExtremum point;
  point.largest = at_low.bend_rad_per_mm_per_mpa * at_low.bend_rad_per_mm * low_kpa > 0;
  point.pressure_kpa =
      bracketed_root(rate, low_kpa, at_low.bend_rad_per_mm_per_mpa, high_kpa, rate(high_kpa), 0);
  point.state = state_of(rods, *at_pressure(rods, point.pressure_kpa, {}), point.pressure_kpa);
  point.name = extremum_text(point, length_mm);
  return point;
}

void find_angle_extrema(const Rods& rods, double length_mm, double end_kpa, Response& response) {
  std::optional<RodsState> before;
  for (int i = 1; i <= scan_steps; ++i) {
    const auto here = at_pressure(rods, end_kpa * i / scan_steps, {});
    if (!here) return;
    if (before && before->bend_rad_per_mm_per_mpa * here->bend_rad_per_mm_per_mpa < 0) {
      response.angle_extrema.push_back(extremum_between(
          rods, length_mm, end_kpa * (i - 1) / scan_steps, end_kpa * i / scan_steps, *before));
    }
    before = here;
  }
}

}  // namespace

void predict_rods(const Rods& rods, double length_mm, std::span<const double> pressures_kpa,
                  Held held, Response& response) {
  using Clock = std::chrono::steady_clock;
  if (!held.stretch) response.solved.emplace_back("stretch");
  if (!held.bend) response.solved.emplace_back("bend-1");
  Clock::time_point since = Clock::now();
  double lowest = 0;
  double highest = 0;
  for (std::size_t i = 0; i < pressures_kpa.size(); ++i) {
    RodsRefusal why{};
    const auto found = at_pressure(rods, pressures_kpa[i], held, &why);
    if (!found) {
      if (response.status != Status::ok) continue;
      response.status = Status::not_converged;
      response.message = refusal_text(rods, pressures_kpa[i], why);
      continue;
    }
    lowest = std::min(lowest, pressures_kpa[i]);
    highest = std::max(highest, pressures_kpa[i]);
    response.states[i] = state_of(rods, *found, pressures_kpa[i]);
    const Clock::time_point now = Clock::now();
    response.states[i]->time_us = std::chrono::duration<double, std::micro>(now - since).count();
    since = now;
  }
  if (held.stretch || held.bend) return;
  if (highest > 0) find_angle_extrema(rods, length_mm, highest, response);
  if (lowest < 0) find_angle_extrema(rods, length_mm, lowest, response);
}

}  // namespace latticast
