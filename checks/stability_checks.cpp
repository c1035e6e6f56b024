// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/stability_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "design/text/written_number.h"

namespace latticast {
namespace {

/// The largest asked pressure of a sign, 0 when there is none.
double largest_kpa(const LoadedSegment& loaded, bool suction) {
  const double end = suction ? loaded.pressures_kpa.front() : loaded.pressures_kpa.back();
  return (end < 0) == suction ? end : 0;
}

const CriticalPoint* end_of_branch(const LoadedSegment& loaded, bool suction) {
  for (const CriticalPoint& point : loaded.response.critical_points) {
    if (point.kind != CriticalKind::bifurcation && (point.pressure_kpa < 0) == suction) {
      return &point;
    }
  }
  return nullptr;
}

void add_end(const LoadedSegment& loaded, const CriticalPoint& end, double asked_kpa,
             CheckFindings& findings) {
  const double margin = end.pressure_kpa / asked_kpa;
  const bool within_load = std::abs(end.pressure_kpa) < std::abs(asked_kpa);
  if (!within_load && !clearly_below(margin, least_limit_margin)) return;
  CheckFinding finding = check_finding(within_load ? "limit-point" : "limit-point-near");
  finding.segment = loaded.number;
  finding.pressure_kpa = end.pressure_kpa;
  finding.value = within_load ? asked_kpa : margin;
  finding.limit = within_load ? end.pressure_kpa : least_limit_margin;
  finding.unit = within_load ? "kPa" : "";
  finding.message =
      within_load ? fmt::format("{}; the load asks for {} kPa", end.name, written(asked_kpa, 4))
                  : fmt::format(
                        "{}, only {} times the largest pressure asked for, {} kPa; a "
                        "rubber softer by that much would not hold it",
                        end.name, written(margin, 3), written(asked_kpa, 4));
  finding.remedy = pressure_remedy(end.pressure_kpa / least_limit_margin) +
                   ", a thicker or stiffer liner, or rings closer together";
  findings.push_back(std::move(finding));
}

/// The pressure at which states turn unstable, if one in the load is.
std::optional<double> first_unstable_kpa(const LoadedSegment& loaded, bool suction) {
  std::optional<double> first;
  const auto take = [&](double pressure) {
    if ((pressure < 0) == suction && (!first || std::abs(pressure) < std::abs(*first))) {
      first = pressure;
    }
  };
  for (const State* state : loaded.states()) {
    if (!state->stable) take(state->pressure_kpa);
  }
  for (const CriticalPoint& point : loaded.response.critical_points) {
    if (point.kind != CriticalKind::bifurcation) continue;
    const double asked = largest_kpa(loaded, suction);
    if (std::abs(point.pressure_kpa) < std::abs(asked)) take(point.pressure_kpa);
  }
  return first;
}

void add_unstable(const LoadedSegment& loaded, double from_kpa, double asked_kpa,
                  CheckFindings& findings) {
  CheckFinding finding = check_finding("unstable-state");
  finding.segment = loaded.number;
  finding.pressure_kpa = from_kpa;
  finding.value = asked_kpa;
  finding.limit = from_kpa;
  finding.unit = "kPa";
  finding.message = fmt::format(
      "the symmetric state is unstable beyond {} kPa, and the load asks for {} kPa: the "
      "segment buckles into another shape, which is not predicted",
      written(from_kpa, 4), written(asked_kpa, 4));
  finding.remedy = pressure_remedy(from_kpa / least_limit_margin);
  findings.push_back(std::move(finding));
}

void add_not_followed(const LoadedSegment& loaded, double asked_kpa, CheckFindings& findings) {
  double followed = 0;
  for (const State* state : loaded.states()) {
    const bool same_sign = (state->pressure_kpa < 0) == (asked_kpa < 0);
    if (same_sign && std::abs(state->pressure_kpa) > std::abs(followed)) {
      followed = state->pressure_kpa;
    }
  }
  CheckFinding finding = check_finding("not-followed");
  finding.segment = loaded.number;
  finding.pressure_kpa = followed;
  finding.value = asked_kpa;
  finding.limit = followed;
  finding.unit = "kPa";
  finding.message =
      fmt::format("{}; the load asks for {} kPa", loaded.response.message, written(asked_kpa, 4));
  finding.remedy = followed == 0 ? "a smaller pressure" : pressure_remedy(followed);
  findings.push_back(std::move(finding));
}

bool has_state_at(const LoadedSegment& loaded, double pressure_kpa) {
  const std::vector<const State*> states = loaded.states();
  return std::any_of(states.begin(), states.end(),
                     [&](const State* state) { return state->pressure_kpa == pressure_kpa; });
}

}  // namespace

void check_stability(const LoadedSegment& loaded, CheckFindings& findings) {
  for (const bool suction : {false, true}) {
    const double asked = largest_kpa(loaded, suction);
    if (asked == 0) continue;
    const CriticalPoint* end = end_of_branch(loaded, suction);
    if (end != nullptr) add_end(loaded, *end, asked, findings);
    if (end == nullptr && !has_state_at(loaded, asked)) {
      add_not_followed(loaded, asked, findings);
    }
    if (const auto from = first_unstable_kpa(loaded, suction)) {
      add_unstable(loaded, *from, asked, findings);
    }
  }
}

}  // namespace latticast
