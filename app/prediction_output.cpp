// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/prediction_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "design/text/written_number.h"
#include "design/units.h"

namespace latticast {
namespace {

double moment_nmm(const State& state) {
  return std::hypot(state.moment_nmm[0], state.moment_nmm[1]);
}

bool bends(const Response& response) {
  return std::any_of(response.states.begin(), response.states.end(), [](const auto& state) {
    return state && (state->bend_magnitude_rad_per_mm() > 0 || moment_nmm(*state) > 0);
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
    if (held.bend) row += fmt::format(" {:11.3f}", moment_nmm(*state));
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

nlohmann::ordered_json to_json(const State& state, const Segment& segment) {
  return {{"pressure_kPa", state.pressure_kpa},
          {"stretch", state.stretch},
          {"twist_deg", twist_deg(state, segment)},
          {"twist_per_length_rad_per_mm", state.twist_rad_per_mm / state.stretch},
          {"bend_deg", bend_deg(state, segment)},
          {"bend_direction_deg", degrees(state.bend_direction_rad())},
          {"kappa_rad_per_mm", state.bend_rad_per_mm},
          {"frame_turn_rad_per_mm", state.frame_turn_rad_per_mm},
          {"inner_radius_mm", state.inner_radius_mm},
          {"outer_radius_mm", state.outer_radius_mm},
          {"torque_Nmm", state.torque_nmm},
          {"moment_Nmm", moment_nmm(state)},
          {"moment_vector_Nmm", state.moment_nmm},
          {"force_N", state.force_n},
          {"stable", state.stable},
          {"smallest_eigenvalue", state.smallest_eigenvalue},
          {"residual", state.residual},
          {"error_estimate", state.error_estimate},
          {"time_us", state.time_us}};
}

nlohmann::ordered_json states_to_json(const Response& response, const Segment& segment) {
  nlohmann::ordered_json states = nlohmann::ordered_json::array();
  for (const std::optional<State>& state : response.states) {
    states.push_back(state ? to_json(*state, segment) : nlohmann::ordered_json(nullptr));
  }
  return states;
}

const char* name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::no_equilibrium:
      return "no_equilibrium";
    case Status::not_converged:
      return "not_converged";
  }
  return "";
}

nlohmann::ordered_json law_json(const StrandLaw& law) {
  nlohmann::ordered_json json;
  for (const auto& [name, size] : describe(law.shape()).sizes) json[std::string(name)] = size;
  json["strain_range"] = {law.range().lowest, law.range().highest};
  json["relative_force_error"] = law.accuracy().force_error;
  return json;
}

nlohmann::ordered_json to_json(const SegmentPrediction& result, const Segment& segment) {
  nlohmann::ordered_json json;
  json["requested_kPa"] = result.pressures_kpa;
  json["status"] = name(result.response.status);
  json["message"] = result.response.message;
  json["limit_points"] = nlohmann::ordered_json::array();
  for (const CriticalPoint& point : result.response.critical_points) {
    json["limit_points"].push_back({{"name", point.name},
                                    {"pressure_kPa", point.pressure_kpa},
                                    {"state", to_json(point.state, segment)}});
  }
  json["turning_points"] = nlohmann::ordered_json::array();
  for (const AngleExtremum& point : result.response.angle_extrema) {
    json["turning_points"].push_back({{"name", point.name},
                                      {"pressure_kPa", point.pressure_kpa},
                                      {"state", to_json(point.state, segment)}});
  }
  json["solved"] = result.response.solved;
  json["horseshoe_laws"] = nlohmann::ordered_json::array();
  for (const auto& law : result.response.laws) {
    json[std::string(path_name(law->shape())) + "_laws"].push_back(law_json(*law));
  }
  json["states"] = states_to_json(result.response, segment);
  if (result.softest) json["softest_liner"] = states_to_json(*result.softest, segment);
  if (result.stiffest) json["stiffest_liner"] = states_to_json(*result.stiffest, segment);
  return json;
}

}  // namespace

std::string prediction_table(const Design& design, const Prediction& prediction, Held held) {
  std::string text;
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    const SegmentPrediction& result = prediction.segments[s];
    const Segment& segment = design.segments[s];
    text += fmt::format("segment {}: {} mm, liner {}\n", s + 1, written(segment.length_mm, 6),
                        segment.liner.material.name);
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

std::string prediction_csv(const Design& design, const Prediction& prediction, Held held) {
  std::string text =
      "segment,pressure_kPa,stretch,twist_deg,twist_per_length_rad_per_mm,bend_deg,"
      "bend_direction_deg,inner_radius_mm,outer_radius_mm,torque_Nmm,moment_Nmm,stable,residual,"
      "error_estimate,time_us";
  text += held.stretch ? ",force_N\n" : "\n";
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    for (const std::optional<State>& state : prediction.segments[s].response.states) {
      if (!state) continue;
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.1f}", s + 1, state->pressure_kpa,
          state->stretch, twist_deg(*state, design.segments[s]),
          state->twist_rad_per_mm / state->stretch, bend_deg(*state, design.segments[s]),
          degrees(state->bend_direction_rad()), state->inner_radius_mm, state->outer_radius_mm,
          state->torque_nmm, moment_nmm(*state), state->stable ? 1 : 0, state->residual,
          state->error_estimate, state->time_us);
      text += held.stretch ? fmt::format(",{}\n", state->force_n) : "\n";
    }
  }
  return text;
}

std::string prediction_json(const Design& design, const Prediction& prediction, Held held) {
  nlohmann::ordered_json json;
  json["design"] = design.name;
  json["held"] = {{"twist", held.twist}, {"stretch", held.stretch}, {"bend", held.bend}};
  json["segments"] = nlohmann::ordered_json::array();
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    json["segments"].push_back(to_json(prediction.segments[s], design.segments[s]));
  }
  return json.dump(2) + "\n";
}

}  // namespace latticast
