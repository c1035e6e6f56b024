// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/law_limits.h"

#include <algorithm>

#include "model/section/section_energy.h"

namespace latticast {
namespace {

constexpr double law_end = 1e-6;  // room in a strand's law, relative, that counts as none

/// What is left of a strand's law on the way to its nearer end: 1 at rest, 0 there, and below 0
/// past it. Empty without such strands, or where the state cannot exist.
std::optional<double> room_in_laws(const Balance& balance, const BranchPoint& x) {
  const auto link = most_strained_link(balance.section(), balance.deformation(x));
  if (!link) return std::nullopt;
  const StrainRange& range = link->range;
  return std::min(1 - link->strain / range.lowest, 1 - link->strain / range.highest);
}

}  // namespace

bool at_law_end(const Balance& balance, const BranchPoint& x) {
  if (stretch_limit_used(balance.section(), balance.deformation(x)) > 1 - law_end) return true;
  const auto room = room_in_laws(balance, x);
  return room && *room < law_end;
}

double length_within_laws(const Balance& balance, const BranchPoint& from,
                          const BranchPoint& tangent, double length) {
  const auto here = room_in_laws(balance, from);
  if (!here) return length;
  BranchPoint ahead = from;
  for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] += length * tangent[i];
  const auto there = room_in_laws(balance, ahead);
  return there && *there < 0 ? length * 0.9 * *here / (*here - *there) : length;
}

}  // namespace latticast
