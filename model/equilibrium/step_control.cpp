// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/step_control.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr double wanted_contraction = 0.08;
constexpr double least_alignment = 0.95;  // cosine between successive tangents
constexpr double least_slope = 1e-12;     // along the branch, above rounding

/// Whether the load between two states may turn back and forth again.
bool may_turn_between(const BranchState& a, const BranchState& b, int n) {
  const double mean = (b.x[n] - a.x[n]) / distance(a.x, b.x);
  return slope_may_vanish(a.tangent[n], b.tangent[n], mean);
}

double change(double contraction) {
  return wanted_contraction / std::max(contraction, 1e-3);
}

}  // namespace

BranchStep judged_step(const BranchState& here, const BranchPoint& start,
                       const std::optional<BranchState>& corrected, int size) {
  if (!corrected) return {};
  // In coordinates alone: a pressure far beyond the liner's strength would hide their changes.
  const double contraction =
      movement(corrected->x, start, size) / std::max(movement(corrected->x, here.x, size), 1e-6);
  const bool accepted = contraction <= greatest_contraction &&
                        dot(corrected->tangent, here.tangent) >= least_alignment &&
                        !may_turn_between(here, *corrected, size);
  return {*corrected, contraction, accepted};
}

double shortened(double length, double contraction) {
  return length * std::clamp(change(contraction), 0.1, 0.5);
}

double lengthened(double length, double contraction) {
  return length * std::clamp(change(contraction), 0.5, 4.0);
}

double longest_step(const BranchPoint& x, int size) {
  return 0.25 * std::max(2.0, 1 + std::max(largest_growth(x, size), std::abs(x[size])));
}

bool slope_may_vanish(double start, double end, double mean) {
  const double sense = start < 0 ? -1 : 1;
  start *= sense;
  end *= sense;
  mean *= sense;
  const double lesser = std::min(start, end);
  if (lesser < least_slope) return false;
  // Past a slope that small against the other end's, the quadratic is no guide.
  if (std::max(start, end) > 8 * lesser) return true;
  // Slope at u in 0..1: start + linear u + square u^2.
  const double linear = 6 * mean - 4 * start - 2 * end;
  const double square = 3 * (start + end) - 6 * mean;
  if (square <= 0) return false;
  const double u = -linear / (2 * square);
  return u > 0 && u < 1 && start + 0.5 * linear * u < 0.5 * lesser;
}

}  // namespace latticast
