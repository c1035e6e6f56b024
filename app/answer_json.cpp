// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answer_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/prediction_output.h"
#include "design/units.h"

namespace latticast {
namespace {

using Json = nlohmann::ordered_json;

// A change that could break who reads it takes the next number (docs/prediction.schema.json).
constexpr int schema_version = 1;

Json head(const Design& design, std::string_view answer) {
  return {{"schema", "latticast-predict"},
          {"schema_version", schema_version},
          {"design", design.name},
          {"answer", answer}};
}

/// How states are written.
struct StateStyle {
  const Segment& segment;
  bool with_times = false;
};

Json state_json(const State& state, const StateStyle& style) {
  Json json = {{"pressure_kPa", state.pressure_kpa},
               {"stretch", state.stretch},
               {"twist_deg", twist_deg(state, style.segment)},
               {"twist_per_length_rad_per_mm", state.twist_rad_per_mm / state.stretch},
               {"bend_deg", bend_deg(state, style.segment)},
               {"bend_direction_deg", degrees(state.bend_direction_rad())},
               {"kappa_rad_per_mm", state.bend_rad_per_mm},
               {"frame_turn_rad_per_mm", state.frame_turn_rad_per_mm},
               {"inner_radius_mm", state.inner_radius_mm},
               {"outer_radius_mm", state.outer_radius_mm},
               {"torque_Nmm", state.torque_nmm},
               {"moment_Nmm", moment_size_nmm(state)},
               {"moment_vector_Nmm", state.moment_nmm},
               {"force_N", state.force_n},
               {"stable", state.stable},
               {"smallest_eigenvalue", state.smallest_eigenvalue},
               {"residual", state.residual},
               {"error_estimate", state.error_estimate}};
  if (style.with_times) json["time_us"] = state.time_us;
  return json;
}

Json state_or_reason(const Response& response, std::size_t i, double pressure_kpa,
                     const StateStyle& style) {
  const std::optional<State>& state = response.states[i];
  if (state) return {{"state", state_json(*state, style)}, {"reason", nullptr}};
  return {{"state", nullptr}, {"reason", reason_of(response, pressure_kpa)}};
}

Json pressures_json(const SegmentPrediction& result, const StateStyle& style) {
  Json list = Json::array();
  for (std::size_t i = 0; i < result.pressures_kpa.size(); ++i) {
    const double pressure = result.pressures_kpa[i];
    const auto end_of_band = [&](const std::optional<Response>& response) -> Json {
      if (!response) return nullptr;
      return state_or_reason(*response, i, pressure, style);
    };
    Json json = {{"pressure_kPa", pressure}};
    json.update(state_or_reason(result.response, i, pressure, style));
    json["softest_liner"] = end_of_band(result.softest);
    json["stiffest_liner"] = end_of_band(result.stiffest);
    list.push_back(std::move(json));
  }
  return list;
}

/// Limit points, or the extrema of angles.
template <class Points>
Json points_json(const Points& points, const StateStyle& style) {
  Json list = Json::array();
  for (const auto& point : points) {
    list.push_back({{"name", point.name},
                    {"pressure_kPa", point.pressure_kpa},
                    {"state", state_json(point.state, style)}});
  }
  return list;
}

Json laws_json(const Response& response) {
  Json list = Json::array();
  for (const auto& law : response.laws) {
    const LinkDescription link = describe(law->shape());
    Json sizes = Json::object();
    for (const auto& [name, size] : link.sizes) sizes[std::string(name)] = size;
    list.push_back({{"path", link.name},
                    {"sizes", std::move(sizes)},
                    {"strain_range", {law->range().lowest, law->range().highest}},
                    {"relative_force_error", law->accuracy().force_error}});
  }
  return list;
}

const char* word(Status status) {
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

Json name_or_null(const std::string& name) {
  return name.empty() ? Json(nullptr) : Json(name);
}

std::string as_text(const Json& json) {
  return json.dump(2) + "\n";
}

}  // namespace

std::string reason_of(const Response& response, double pressure_kpa) {
  for (const CriticalPoint& point : response.critical_points) {
    const bool is_on_the_way = std::signbit(point.pressure_kpa) == std::signbit(pressure_kpa) &&
                               std::abs(point.pressure_kpa) <= std::abs(pressure_kpa);
    if (is_on_the_way) return point.name;
  }
  return response.message;
}

std::string response_json(const Design& design, const Prediction& prediction, Held held,
                          bool with_times) {
  Json json = head(design, "response");
  json["held"] = {{"twist", held.twist}, {"stretch", held.stretch}, {"bend", held.bend}};
  json["segments"] = Json::array();
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    const SegmentPrediction& result = prediction.segments[s];
    const StateStyle style{design.segments[s], with_times};
    json["segments"].push_back(
        {{"segment", s + 1},
         {"name", name_or_null(style.segment.name)},
         {"length_mm", style.segment.length_mm},
         {"liner", style.segment.liner.material.name},
         {"status", word(result.response.status)},
         {"message", result.response.message},
         {"solved", result.response.solved},
         {"limit_points", points_json(result.response.critical_points, style)},
         {"turning_points", points_json(result.response.angle_extrema, style)},
         {"strand_laws", laws_json(result.response)},
         {"pressures", pressures_json(result, style)}});
  }
  return as_text(json);
}

std::string rows_json(const Design& design, std::string_view answer, const NumberRows& numbers) {
  Json json = head(design, answer);
  json["rows"] = Json::array();
  for (const std::vector<double>& row : numbers.rows) {
    Json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[numbers.columns[i]] = row[i];
    json["rows"].push_back(std::move(object));
  }
  json["missing"] = Json::array();
  for (const MissingRow& missing : numbers.missing) {
    Json object;
    for (const auto& [name, number] : missing.of) object[name] = number;
    object["reason"] = missing.reason;
    json["missing"].push_back(std::move(object));
  }
  return as_text(json);
}

}  // namespace latticast
