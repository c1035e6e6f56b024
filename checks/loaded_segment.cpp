// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/loaded_segment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "model/cell/cell_wall.h"
#include "model/segment_response.h"

namespace latticast {

/// Walls of a unit cell that have been looked at.
class WallsByPressure {
 public:
  explicit WallsByPressure(const PreparedSegment& segment)
      : section_(std::get<Section>(segment.section)), walls_(*segment.cell) {}

  const CellWall* at(const State& state) {
    const auto [found, is_new] = found_.try_emplace(state.pressure_kpa);
    if (is_new) {
      found->second = walls_.at(state.deformation(section_.inner_radius_mm, section_.axis_rad));
    }
    return found->second ? &*found->second : nullptr;
  }

 private:
  const Section& section_;
  CellWalls walls_;
  std::map<double, std::optional<CellWall>> found_;
};

namespace {

constexpr int steps_of_load = 8;

constexpr std::size_t most_asked = 64;

void sort_distinct(std::vector<double>& pressures) {
  std::sort(pressures.begin(), pressures.end());
  pressures.erase(std::unique(pressures.begin(), pressures.end()), pressures.end());
}

/// Distinct ones of the asked pressures, ascending; of very many some, the ends among them.
std::vector<double> asked_pressures_kpa(const Design& design, std::size_t index) {
  std::vector<double> pressures;
  for (const LoadCase& load : design.load) pressures.push_back(load.pressures_kpa[index]);
  sort_distinct(pressures);
  if (pressures.size() <= most_asked) return pressures;
  std::vector<double> some;
  for (std::size_t i = 0; i < most_asked; ++i) {
    some.push_back(pressures[i * (pressures.size() - 1) / (most_asked - 1)]);
  }
  return some;
}

std::vector<double> pressures_of_load_kpa(const Design& design, std::size_t index) {
  std::vector<double> pressures = asked_pressures_kpa(design, index);
  const double least = std::min(0.0, pressures.front());
  const double most = std::max(0.0, pressures.back());
  for (int i = 1; i < steps_of_load; ++i) {
    pressures.push_back(most * i / steps_of_load);
    pressures.push_back(least * i / steps_of_load);
  }
  sort_distinct(pressures);
  return pressures;
}

bool beyond(const Measure& measure, const State& state) {
  const double value = measure.value(state);
  return measure.upper ? clearly_above(value, measure.limit) : clearly_below(value, measure.limit);
}

/// The first of evenly spaced pressures from `within` to `outside` at which the measure is beyond
/// its limit, and the one before. A pressure without a state counts as within.
void narrow(const LoadedSegment& loaded, const Measure& measure, double& within, double& outside) {
  constexpr int parts = 16;
  std::vector<double> pressures;
  for (int i = 1; i < parts; ++i) pressures.push_back(within + (outside - within) * i / parts);
  const Response& response = loaded.response_at(pressures);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const auto& state = response.states[i];
    if (state && beyond(measure, *state)) {
      outside = pressures[i];
      return;
    }
    within = pressures[i];
  }
}

}  // namespace

std::vector<const State*> LoadedSegment::states() const {
  std::vector<const State*> found;
  for (std::size_t i = 0; i < pressures_kpa.size(); ++i) {
    if (response.states[i]) found.push_back(&*response.states[i]);
  }
  return found;
}

const CellWall* LoadedSegment::wall(const State& state) const {
  return walls ? walls->at(state) : nullptr;
}

const PreparedSegment& LoadedSegment::section() const {
  return responses->section(static_cast<std::size_t>(number) - 1);
}

const Response& LoadedSegment::response_at(const std::vector<double>& other_kpa,
                                           ModulusFactors factors) const {
  return responses->response(static_cast<std::size_t>(number) - 1, other_kpa, factors);
}

LoadedSegment load_segment(PreparedResponses& responses, std::size_t index) {
  const Design& design = responses.design();
  LoadedSegment loaded;
  loaded.segment = &design.segments[index];
  loaded.number = static_cast<int>(index) + 1;
  loaded.responses = &responses;
  loaded.pressures_kpa = pressures_of_load_kpa(design, index);
  std::vector<double> pressures = loaded.pressures_kpa;
  const double most = loaded.pressures_kpa.back();
  const double least = loaded.pressures_kpa.front();
  if (most > 0) pressures.push_back(least_limit_margin * most);
  if (least < 0) pressures.push_back(least_limit_margin * least);
  loaded.response = responses.response(index, pressures);
  if (loaded.section().cell) loaded.walls = std::make_shared<WallsByPressure>(loaded.section());
  return loaded;
}

std::optional<Excess> excess(const LoadedSegment& loaded, const Measure& measure) {
  std::optional<Excess> found;
  double within = 0;
  double nearest = HUGE_VAL;
  std::vector<const State*> states = loaded.states();
  std::stable_sort(states.begin(), states.end(), [](const State* a, const State* b) {
    return std::abs(a->pressure_kpa) < std::abs(b->pressure_kpa);
  });
  for (const State* state : states) {
    if (!beyond(measure, *state)) continue;
    const double value = measure.value(*state);
    if (!found) {
      nearest = state->pressure_kpa;
      found = Excess{nearest, nearest, nearest, value};
    }
    if (measure.upper ? value > found->worst : value < found->worst) {
      found->worst = value;
      found->worst_kpa = state->pressure_kpa;
    }
  }
  if (!found || nearest == 0) return found;
  for (const State* state : states) {
    const bool same_sign = (state->pressure_kpa < 0) == (nearest < 0);
    if (same_sign && std::abs(state->pressure_kpa) < std::abs(nearest)) {
      within = state->pressure_kpa;
    }
  }
  narrow(loaded, measure, within, nearest);
  narrow(loaded, measure, within, nearest);
  found->from_kpa = nearest;
  found->safe_kpa = within;
  return found;
}

CheckFinding finding_of(const LoadedSegment& loaded, const Measure& measure, const Excess& excess) {
  CheckFinding finding = check_finding(measure.code);
  finding.segment = loaded.number;
  finding.part = measure.part;
  finding.pressure_kpa = excess.from_kpa;
  finding.value = excess.worst;
  finding.limit = measure.limit;
  finding.unit = measure.unit;
  return finding;
}

std::string pressure_remedy(double limit_kpa) {
  if (limit_kpa == 0) return "no pressure";
  const double step = std::pow(10, std::floor(std::log10(std::abs(limit_kpa))) - 2);
  const double rounded = std::trunc(limit_kpa / step) * step;
  return fmt::format("pressure {} to {} kPa", rounded < 0 ? "down" : "up", written(rounded, 3));
}

}  // namespace latticast
