// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/prediction_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"

namespace latticast {
namespace {

bool bends(const Response& response) {
  return std::any_of(response.states.begin(), response.states.end(), [](const auto& state) {
    return state && (state->bend_magnitude_rad_per_mm() > 0 || moment_size_nmm(*state) > 0);
  });
}

bool twists(const Response& response) {
  return std::any_of(response.states.begin(), response.states.end(), [](const auto& state) {
    return state && (state->twist_rad_per_mm != 0 || state->torque_nmm != 0);
  });
}

// "1.30 .. 1.62": the same number at the two ends of the modulus band.
template <class Number>
std::string band(const SegmentPrediction& result, std::size_t i, const char* format,
                 Number number) {
  const auto end = [&](const std::optional<Response>& response) -> std::string {
    const Response& used = response ? *response : result.response;
    return used.states[i] ? fmt::format(fmt::runtime(format), number(*used.states[i])) : "none";
  };
  if (!result.softest && !result.stiffest) return "";
  return fmt::format("{} .. {}", end(result.stiffest), end(result.softest));
}

std::string table_row(const SegmentPrediction& result, std::size_t i, const Segment& segment,
                      Held held) {
  const std::optional<State>& state = result.response.states[i];
  if (!state) return fmt::format("{:9.2f}  no equilibrium\n", result.pressures_kpa[i]);
  const auto turn = [&](const State& s) { return twist_deg(s, segment); };
  const auto bend = [&](const State& s) { return bend_deg(s, segment); };
  const auto stretch = [](const State& s) { return s.stretch; };
  std::string row =
      fmt::format("{:9.2f} {:8.5f} {:9.3f} {:8.3f} {:8.3f}", state->pressure_kpa, state->stretch,
                  turn(*state), state->inner_radius_mm, state->outer_radius_mm);
  if (bends(result.response)) {
    row += fmt::format(" {:9.3f} {:7.2f}", bend_deg(*state, segment),
                       degrees(state->bend_direction_rad()));
    if (held.bend) row += fmt::format(" {:11.3f}", moment_size_nmm(*state));
  }
  if (held.twist) row += fmt::format(" {:11.3f}", state->torque_nmm);
  if (held.stretch) row += fmt::format(" {:9.4f}", state->force_n);
  row += fmt::format("  {:<7} {:8.1e}", state->stable ? "yes" : "no", state->error_estimate);
  if (result.softest || result.stiffest) {
    row += fmt::format("  {:<18}", band(result, i, "{:.3f}", stretch));
    if (twists(result.response)) row += fmt::format("  {:<18}", band(result, i, "{:.1f}", turn));
    if (bends(result.response)) row += fmt::format("  {:<18}", band(result, i, "{:.1f}", bend));
  }
  return row + "\n";
}

}  // namespace

double moment_size_nmm(const State& state) {
  return std::hypot(state.moment_nmm[0], state.moment_nmm[1]);
}

std::string prediction_table(const Design& design, const Prediction& prediction, Held held) {
  std::string text;
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    const SegmentPrediction& result = prediction.segments[s];
    const Segment& segment = design.segments[s];
    text += fmt::format("segment {}{}: {} mm, liner {}\n", s + 1,
                        segment.name.empty() ? "" : fmt::format(" ({})", segment.name),
                        written(segment.length_mm, 6), segment.liner.material.name);
    text += fmt::format("{:>9} {:>8} {:>9} {:>8} {:>8}", "P kPa", "stretch", "twist deg", "r_i mm",
                        "r_o mm");
    if (bends(result.response)) {
      text += fmt::format(" {:>9} {:>7}", "bend deg", "toward");
      if (held.bend) text += fmt::format(" {:>11}", "moment N mm");
    }
    if (held.twist) text += fmt::format(" {:>11}", "torque N mm");
    if (held.stretch) text += fmt::format(" {:>9}", "force N");
    text += fmt::format("  {:<7} {:<8}", "stable", "error");
    if (result.softest || result.stiffest) {
      text += fmt::format("  {:<18}", "stretch, band");
      if (twists(result.response)) text += fmt::format("  {:<18}", "twist, band");
      if (bends(result.response)) text += fmt::format("  {:<18}", "bend, band");
    }
    text += "\n";
    for (std::size_t i = 0; i < result.pressures_kpa.size(); ++i) {
      text += table_row(result, i, segment, held);
    }
  }
  return text;
}

std::string prediction_csv(const Design& design, const Prediction& prediction, Held held,
                           bool with_times) {
  std::string text =
      "segment,pressure_kPa,stretch,twist_deg,twist_per_length_rad_per_mm,bend_deg,"
      "bend_direction_deg,inner_radius_mm,outer_radius_mm,torque_Nmm,moment_Nmm,stable,residual,"
      "error_estimate,time_us";
  text += held.stretch ? ",force_N\n" : "\n";
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    for (const std::optional<State>& state : prediction.segments[s].response.states) {
      if (!state) continue;
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s + 1, state->pressure_kpa,
          state->stretch, twist_deg(*state, design.segments[s]),
          state->twist_rad_per_mm / state->stretch, bend_deg(*state, design.segments[s]),
          degrees(state->bend_direction_rad()), state->inner_radius_mm, state->outer_radius_mm,
          state->torque_nmm, moment_size_nmm(*state), state->stable ? 1 : 0, state->residual,
          state->error_estimate, with_times ? fmt::format("{:.1f}", state->time_us) : "");
      text += held.stretch ? fmt::format(",{}\n", state->force_n) : "\n";
    }
  }
  return text;
}

}  // namespace latticast
