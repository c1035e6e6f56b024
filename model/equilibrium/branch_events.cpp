// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch_events.h"

#include <cmath>

#include "model/equilibrium/step_control.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr double bifurcation_accuracy = 1e-12;  // of its load, relative
constexpr double limit_accuracy = 1e-6;         // of its load, relative
constexpr int most_event_searches = 60;
constexpr int limit_checks = 8;  // parts of the way to a limit point

/// Relative error of a limit point's pressure: what the finer energy pushes along the branch, over
/// what the load does.
double limit_pressure_error(const EquilibriumEquations& equations, const BranchState& limit) {
  const auto finer = equations.finer_at(limit.x);
  if (!finer) return HUGE_VAL;
  double pushed = 0;
  double loaded = 0;
  for (int i = 0; i < equations.size; ++i) {
    pushed += limit.tangent[i] * finer->residual[i];
    loaded += limit.tangent[i] * finer->load_vector[i];
  }
  return 2 * std::abs(pushed / (loaded * limit.x[equations.size]));
}

BranchPoint bore_axis(int size) {
  BranchPoint axis{};
  axis[size - 1] = 1;
  return axis;
}

}  // namespace

BranchPoint limit_point_guess(const BranchState& here, const BranchState& beyond) {
  const double before = std::abs(here.nearest_solved_eigenvalue);
  const double after = std::abs(beyond.nearest_solved_eigenvalue);
  return between(here.x, beyond.x, before / (before + after));
}

bool lies_between(const BranchPoint& x, const BranchState& here, const BranchState& beyond) {
  const double most = 1.1 * distance(here.x, beyond.x);
  return distance(x, here.x) <= most && distance(x, beyond.x) <= most;
}

bool is_connected(const BranchState& here, const BranchPoint& limit, int size,
                  const CorrectInPlane& correct) {
  const double length = distance(limit, here.x);
  BranchPoint chord{};
  for (int i = 0; i <= size; ++i) chord[i] = (limit[i] - here.x[i]) / length;
  for (int i = 1; i < limit_checks; ++i) {
    const BranchPoint start = between(here.x, limit, static_cast<double>(i) / limit_checks);
    const auto state = correct(start, chord);
    if (!state || state->negative_eigenvalues != here.negative_eigenvalues ||
        distance(state->x, start) > greatest_contraction * length ||
        std::abs(state->x[size]) > std::abs(limit[size])) {
      return false;
    }
  }
  return true;
}

std::optional<CriticalState> limit_point_between(const EquilibriumEquations& equations,
                                                 const BranchState& here, const BranchState& beyond,
                                                 const CorrectInPlane& correct) {
  const int n = equations.size;
  const double step = distance(here.x, beyond.x);
  BranchPoint chord{};
  for (std::size_t i = 0; i < chord.size(); ++i) chord[i] = (beyond.x[i] - here.x[i]) / step;
  const double sign = here.tangent[n] > 0 ? 1 : -1;
  RootSearch search(0, std::abs(here.tangent[n]), step, -std::abs(beyond.tangent[n]));
  for (int i = 0; i < most_event_searches; ++i) {
    const double way = search.next();
    const BranchPoint start = between(here.x, beyond.x, way / step);
    const auto middle = correct(start, chord);
    if (!middle || distance(middle->x, start) > greatest_contraction * step) return std::nullopt;
    const double along = dot(middle->tangent, chord) > 0 ? 1 : -1;
    const double rise = sign * along * middle->tangent[n];
    // The pressure's distance from its extreme is of second order in its slope.
    if (std::abs(rise) * search.width() < limit_accuracy * std::abs(middle->x[n])) {
      return CriticalState{CriticalKind::limit_point, middle->x, middle->balance,
                           limit_pressure_error(equations, *middle)};
    }
    search.narrow(way, rise);
  }
  return std::nullopt;
}

std::optional<CriticalState> bifurcation_between(const BranchState& here, const BranchState& beyond,
                                                 int size, const CorrectInPlane& correct) {
  const double step = distance(here.x, beyond.x);
  BranchPoint low = here.x;
  BranchPoint high = beyond.x;
  const double at_low = std::abs(here.nearest_eigenvalue);
  const double at_high = -std::abs(beyond.nearest_eigenvalue);
  const double slope = (at_low - at_high) / (low[size] - high[size]);
  RootSearch search(low[size], at_low, high[size], at_high);
  for (int i = 0; i < most_event_searches; ++i) {
    const double load = search.next();
    const double fraction = (load - low[size]) / (high[size] - low[size]);
    const BranchPoint start = at_load(between(low, high, fraction), load, size);
    const auto middle = correct(start, load_axis(size));
    if (!middle || distance(middle->x, start) > greatest_contraction * step) return std::nullopt;
    const double error = std::abs(middle->nearest_eigenvalue / (slope * middle->x[size]));
    if (error < bifurcation_accuracy) {
      return CriticalState{CriticalKind::bifurcation, middle->x, middle->balance, error};
    }
    const bool before = middle->negative_eigenvalues == here.negative_eigenvalues;
    (before ? low : high) = middle->x;
    search.narrow(load, std::abs(middle->nearest_eigenvalue) * (before ? 1 : -1));
  }
  return std::nullopt;
}

BranchPoint closure_guess(const BranchState& here, const BranchState& beyond, int size) {
  const double open = here.x[size - 1];
  BranchPoint start = between(here.x, beyond.x, (closed_bore - open) / (beyond.x[size - 1] - open));
  start[size - 1] = closed_bore;
  return start;
}

std::optional<BranchState> closed_from(const BranchPoint& start, int size,
                                       const CorrectInPlane& correct) {
  return correct(start, bore_axis(size));
}

double closure_error(const BranchState& closed, const BalanceAt& finer, int size) {
  const BranchPoint change = correction(closed.balance, finer.residual, bore_axis(size), size);
  return std::abs(change[size] / closed.x[size]);
}

CriticalState asymptote_at(const BranchState& here, int size) {
  const double left = std::abs(here.tangent[size]) * largest_growth(here.x, size);
  return {.kind = CriticalKind::asymptote,
          .x = here.x,
          .balance = here.balance,
          .pressure_error = left / std::abs(here.x[size])};
}

std::optional<BranchState> landed_before(const BranchState& here, const BranchPoint& limit,
                                         double load, int size, const CorrectInPlane& correct) {
  const double left = (limit[size] - load) / (limit[size] - here.x[size]);
  const BranchPoint start = at_load(between(limit, here.x, std::sqrt(left)), load, size);
  auto state = correct(start, load_axis(size));
  if (!state || state->negative_eigenvalues != here.negative_eigenvalues ||
      movement(state->x, start, size) > greatest_contraction * movement(state->x, here.x, size)) {
    return std::nullopt;
  }
  return state;
}

}  // namespace latticast
