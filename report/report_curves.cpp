// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_curves.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "prepared/prepared_responses.h"

namespace latticast {
namespace {

constexpr int even_steps = 32;
constexpr std::size_t most_cases = 2000;  // more points than these say no more in a picture

std::set<double> even_pressures(const std::vector<double>& asked) {
  const double low = std::min(0.0, *std::min_element(asked.begin(), asked.end()));
  const double high = std::max(0.0, *std::max_element(asked.begin(), asked.end()));
  std::set<double> pressures(asked.begin(), asked.end());
  pressures.insert(0);
  for (int i = 0; i <= even_steps; ++i) {
    const double pressure = low + (high - low) * i / even_steps;
    // Beside an asked one, and not the same by rounding alone.
    const auto next = pressures.lower_bound(pressure - 1e-9 * (high - low));
    if (next == pressures.end() || *next > pressure + 1e-9 * (high - low)) {
      pressures.insert(pressure);
    }
  }
  return pressures;
}

// A branch turns back like a square root: even steps would cut its end off.
std::set<double> toward_ends(const Response& response, const std::set<double>& pressures) {
  std::set<double> more;
  for (const CriticalPoint& limit : response.critical_points) {
    if (limit.kind == CriticalKind::bifurcation) continue;
    const auto next = pressures.lower_bound(limit.pressure_kpa);
    const bool above = limit.pressure_kpa > 0;
    if (next == pressures.begin() || next == pressures.end()) continue;
    const double inside = above ? *std::prev(next) : *next;
    for (double rest = 0.5; rest > 1e-5; rest *= 0.25) {
      more.insert(limit.pressure_kpa + rest * (inside - limit.pressure_kpa));
    }
  }
  return more;
}

ResponseCurve predict_curve(PreparedResponses& responses, std::size_t segment,
                            const std::vector<double>& asked) {
  std::set<double> pressures = even_pressures(asked);
  const auto listed = [&] { return std::vector<double>(pressures.begin(), pressures.end()); };
  pressures.merge(toward_ends(responses.response(segment, listed()), pressures));
  ResponseCurve curve{responses.prediction(segment, listed(), true), {}};
  const std::set<double> named(asked.begin(), asked.end());
  for (const double pressure : pressures) curve.asked.push_back(named.count(pressure) > 0);
  return curve;
}

// Where a unit cell is worth its time to the user, so is what it is compared with.
std::vector<KindPrediction> other_kinds(const Design& design) {
  const WallKind own = design.model.wall;
  std::vector<KindPrediction> others;
  if (own != WallKind::unit_cell &&
      (own != WallKind::bonded || design.model.calibrate == Calibrate::nothing)) {
    return others;
  }
  for (const WallKind kind : compared_kinds) {
    if (kind != own) others.push_back(predict_kind(design, kind, {}, {}));
  }
  return others;
}

}  // namespace

std::vector<State> ResponseCurve::states() const {
  std::vector<State> found;
  for (const std::optional<State>& state : prediction.response.states) {
    if (state) found.push_back(*state);
  }
  return found;
}

ReportCurves predict_curves(PreparedResponses& responses) {
  const Design& design = responses.design();
  ReportCurves curves;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    curves.segments.push_back(predict_curve(responses, s, segment_pressures_kpa(design, s, {})));
  }
  curves.other_kinds = other_kinds(design);
  std::vector<LoadCase> cases = design.load;
  if (cases.size() > most_cases) {
    curves.cases_left_out = cases.size() - most_cases;
    cases.resize(most_cases);
  }
  curves.chain = responses.chain(cases);
  return curves;
}

}  // namespace latticast
