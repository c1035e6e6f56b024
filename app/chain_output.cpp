// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chain_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "app/answer_json.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "model/shape/shape.h"

namespace latticast {
namespace {
constexpr int line_steps = 20;

std::vector<std::string> case_columns(std::size_t segments) {
  std::vector<std::string> columns = {"case"};
  for (std::size_t s = 0; s < segments; ++s) {
    columns.push_back(fmt::format("pressure_{}_kPa", s + 1));
  }
  return columns;
}

std::vector<double> case_numbers(const ChainResponse& chain, std::size_t load_case) {
  std::vector<double> numbers = {static_cast<double>(load_case + 1)};
  const std::vector<double>& pressures = chain.cases[load_case].pressures_kpa;
  numbers.insert(numbers.end(), pressures.begin(), pressures.end());
  return numbers;
}

template <class T>
void append(std::vector<T>& list, std::initializer_list<T> more) {
  list.insert(list.end(), more);
}

bool all_stable(const std::vector<State>& states) {
  return std::all_of(states.begin(), states.end(), [](const State& s) { return s.stable; });
}

}  // namespace

NumberRows tip_rows(const ChainResponse& chain, std::span<const Segment> segments) {
  NumberRows result{case_columns(segments.size()), {}};
  append<std::string>(result.columns,
                      {"x_mm", "y_mm", "z_mm", "axis_x", "axis_y", "axis_z", "mark_x", "mark_y",
                       "mark_z", "tilt_deg", "twist_deg", "length_mm", "stable"});
  for (std::size_t i = 0; i < chain.cases.size(); ++i) {
    const auto states = states_in(chain, i);
    if (!states) continue;
    const Shape shape(segments, *states);
    const auto& [place, rotation] = shape.tip();
    std::vector<double> row = case_numbers(chain, i);
    append(row, {place[0], place[1], place[2]});
    append(row, {rotation[0][2], rotation[1][2], rotation[2][2]});
    append(row, {rotation[0][0], rotation[1][0], rotation[2][0]});
    append(row, {degrees(tilt_rad(rotation)), degrees(shape.end_rotation_rad()), shape.length_mm(),
                 all_stable(*states) ? 1.0 : 0.0});
    result.rows.push_back(std::move(row));
  }
  return result;
}

NumberRows centre_line_rows(const ChainResponse& chain, std::span<const Segment> segments) {
  NumberRows result{case_columns(segments.size()), {}};
  append<std::string>(result.columns, {"rest_mm", "x_mm", "y_mm", "z_mm"});
  for (std::size_t i = 0; i < chain.cases.size(); ++i) {
    const auto shape = shape_in(chain, segments, i);
    if (!shape) continue;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      for (int step = s == 0 ? 0 : 1; step <= line_steps; ++step) {
        const double along = segments[s].length_mm * step / line_steps;
        const Point place = shape->frame_at(s, along).origin;
        std::vector<double> row = case_numbers(chain, i);
        append(row, {shape->z_begin_mm(s) + along, place[0], place[1], place[2]});
        result.rows.push_back(std::move(row));
      }
    }
  }
  return result;
}

std::vector<MissingRow> missing_cases(const ChainResponse& chain) {
  std::vector<MissingRow> missing;
  for (std::size_t i = 0; i < chain.cases.size(); ++i) {
    if (states_in(chain, i)) continue;
    MissingRow row{{{"case", static_cast<double>(i + 1)}}, {}};
    for (std::size_t s = 0; s < chain.responses.size(); ++s) {
      const double pressure = chain.cases[i].pressures_kpa[s];
      row.of.emplace_back(fmt::format("pressure_{}_kPa", s + 1), pressure);
      const std::vector<double>& known = chain.pressures_kpa[s];
      const auto at = std::find(known.begin(), known.end(), pressure) - known.begin();
      if (chain.responses[s].states[static_cast<std::size_t>(at)]) continue;
      row.reason += fmt::format("{}segment {}: {}", row.reason.empty() ? "" : "; ", s + 1,
                                reason_of(chain.responses[s], pressure));
    }
    missing.push_back(std::move(row));
  }
  return missing;
}

std::string reach_summary(const ChainResponse& chain, std::span<const Segment> segments) {
  std::size_t found = 0;
  double nearest = HUGE_VAL, farthest = 0, lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (std::size_t i = 0; i < chain.cases.size(); ++i) {
    const auto shape = shape_in(chain, segments, i);
    if (!shape) continue;
    ++found;
    const Point tip = shape->tip().origin;
    const double off_axis = std::hypot(tip[0], tip[1]);
    nearest = std::min(nearest, off_axis);
    farthest = std::max(farthest, off_axis);
    lowest = std::min(lowest, tip[2]);
    highest = std::max(highest, tip[2]);
  }
  if (found == 0) return "no case has an equilibrium";
  return fmt::format(
      "{} of {} cases have an equilibrium; the tip is {} to {} mm off the base's axis and "
      "{} to {} mm above the base",
      found, chain.cases.size(), written(nearest, 3), written(farthest, 4), written(lowest, 4),
      written(highest, 4));
}

}  // namespace latticast
