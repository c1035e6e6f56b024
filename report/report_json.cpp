// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <variant>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "design/units.h"
#include "design/wall_kind.h"
#include "model/shape/shape.h"
#include "report/checks_json.h"
#include "report/report_data.h"

namespace latticast {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t most_line_points = 20000;  // of all cases together

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// --- The design
// -----------------------------------------------------------------------------------

Json grid_json(const Grid& grid) {
  Json json{{"angle_deg", grid.angle_deg}, {"count", grid.count()}, {"widths_mm", grid.widths_mm}};
  json["horseshoe"] = nullptr;
  if (!is_curved(grid.path)) return json;
  const PathDescription path = describe(grid.path);
  Json sizes = Json::object();
  for (const auto& parameter : path.parameters) {
    std::visit([&](auto size) { sizes[std::string(parameter.first)] = size; }, parameter.second);
  }
  json[std::string(path.name)] = std::move(sizes);
  return json;
}

Json lattice_json(const Lattice& lattice) {
  Json json{{"thickness_mm", lattice.thickness_mm},
            {"material", lattice.material.name},
            {"fillet_mm", lattice.fillet_mm},
            {"rings", nullptr},
            {"grids", Json::array()}};
  if (lattice.rings) {
    json["rings"] = {{"count", or_null(lattice.rings->count)},
                     {"pitch_mm", or_null(lattice.rings->pitch_mm)},
                     {"width_mm", lattice.rings->width_mm}};
    if (lattice.rings->phase != Rings::usual_phase) json["rings"]["phase"] = lattice.rings->phase;
  }
  for (const Grid& grid : lattice.grids) json["grids"].push_back(grid_json(grid));
  return json;
}

Json segment_json(const Segment& segment, std::size_t number) {
  return {
      {"number", number},
      {"length_mm", segment.length_mm},
      {"inner_radius_mm", segment.inner_radius_mm()},
      {"liner_outer_radius_mm", segment.liner_outer_radius_mm()},
      {"outer_radius_mm", segment.outer_radius_mm()},
      {"liner",
       {{"thickness_mm", segment.liner.thickness_mm}, {"material", segment.liner.material.name}}},
      {"lattice", segment.lattice ? lattice_json(*segment.lattice) : Json(nullptr)}};
}

const char* name(JointModel joint) {
  switch (joint) {
    case JointModel::none:
      return "none";
    case JointModel::paper:
      return "paper";
    case JointModel::clear_span:
      return "clear-span";
  }
  return "";
}

Json design_json(const Design& design) {
  Json segments = Json::array();
  for (const Segment& segment : design.segments) {
    segments.push_back(segment_json(segment, segments.size() + 1));
  }
  return {{"segments", segments},
          {"model",
           {{"kind", word_of(design.model.wall, wall_kinds)},
            {"columns", design.model.columns == ColumnModel::distributed ? "distributed" : "rods"},
            {"joint", name(design.model.joint)}}},
          {"tolerance_mm", design.output.tolerance_mm}};
}

Json parameters_json(const Law& law) {
  Json parameters = Json::object();
  for (const LawConstant& constant : constants_of(law)) {
    std::string key(constant.key);
    if (!constant.unit.empty()) key += fmt::format("_{}", constant.unit);
    parameters[key] = constant.is_list ? Json(constant.values) : Json(constant.values.front());
  }
  return parameters;
}

bool is_same_law(const Law& a, const Law& b) {
  return law_name(a) == law_name(b) && parameters_json(a) == parameters_json(b);
}

Json material_json(const Material& material, const std::set<std::string>& roles) {
  return {{"name", material.name},
          {"role", roles},
          {"law", law_name(material.law)},
          {"parameters", parameters_json(material.law)},
          {"density_g_per_cm3", or_null(material.density_g_per_cm3)},
          {"source", material.source},
          {"note", material.note}};
}

// Each material once, with all that it is used for; inline ones are told apart by their numbers.
Json materials_json(const Design& design) {
  std::vector<std::pair<const Material*, std::set<std::string>>> used;
  const auto add = [&](const Material& material, const char* role) {
    for (auto& [known, roles] : used) {
      if (known->name != material.name || !is_same_law(known->law, material.law)) continue;
      roles.insert(role);
      return;
    }
    used.push_back({&material, {role}});
  };
  for (const Segment& segment : design.segments) {
    add(segment.liner.material, "liner");
    if (segment.lattice) add(segment.lattice->material, "lattice");
  }
  Json materials = Json::array();
  for (const auto& [material, roles] : used) materials.push_back(material_json(*material, roles));
  return materials;
}

// --- The response
// ---------------------------------------------------------------------------------

Json state_json(const State& state, const Segment& segment) {
  return {{"pressure_kPa", state.pressure_kpa},
          {"stretch", state.stretch},
          {"length_mm", state.stretch * segment.length_mm},
          {"twist_deg", twist_deg(state, segment)},
          {"bend_deg", bend_deg(state, segment)},
          {"bend_direction_deg", degrees(state.bend_direction_rad())},
          {"inner_radius_mm", state.inner_radius_mm},
          {"outer_radius_mm", state.outer_radius_mm},
          {"stable", state.stable},
          {"residual", state.residual},
          {"error_estimate", state.error_estimate}};
}

Json curve_json(const ResponseCurve& curve, const Segment& segment) {
  Json points = Json::array();
  for (std::size_t i = 0; i < curve.asked.size(); ++i) {
    const auto& state = curve.prediction.response.states[i];
    if (!state) continue;
    points.push_back(state_json(*state, segment));
    points.back()["asked"] = static_cast<bool>(curve.asked[i]);
  }
  return points;
}

Json band_edge_json(const Response& response, const Segment& segment) {
  Json points = Json::array();
  for (const auto& state : response.states) {
    if (!state) continue;
    points.push_back({{"pressure_kPa", state->pressure_kpa},
                      {"stretch", state->stretch},
                      {"twist_deg", twist_deg(*state, segment)},
                      {"bend_deg", bend_deg(*state, segment)},
                      {"outer_radius_mm", state->outer_radius_mm}});
  }
  return points;
}

// An edge that the material does not state is the curve itself.
Json band_json(const SegmentPrediction& prediction, const Segment& segment) {
  if (!prediction.softest && !prediction.stiffest) return nullptr;
  const Material& liner = segment.liner.material;
  const auto edge = [&](const std::optional<Response>& response) {
    return band_edge_json(response ? *response : prediction.response, segment);
  };
  return {{"low_factor", liner.modulus_low_factor.value_or(1)},
          {"high_factor", liner.modulus_high_factor.value_or(1)},
          {"softest", edge(prediction.softest)},
          {"stiffest", edge(prediction.stiffest)}};
}

const char* name(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::limit_point:
      return "limit-point";
    case CriticalKind::asymptote:
      return "asymptote";
    case CriticalKind::closure:
      return "closure";
    case CriticalKind::bifurcation:
      return "bifurcation";
  }
  return "";
}

Json limits_json(const Response& response) {
  Json limits = Json::array();
  for (const CriticalPoint& limit : response.critical_points) {
    limits.push_back(
        {{"kind", name(limit.kind)}, {"pressure_kPa", limit.pressure_kpa}, {"text", limit.name}});
  }
  return limits;
}

Json turning_json(const Response& response, const Segment& segment) {
  Json points = Json::array();
  for (const AngleExtremum& point : response.angle_extrema) {
    const bool bends = point.quantity == AngleKind::bend;
    points.push_back(
        {{"quantity", bends ? "bend" : "twist"},
         {"pressure_kPa", point.pressure_kpa},
         {"value_deg", bends ? bend_deg(point.state, segment) : twist_deg(point.state, segment)},
         {"text", point.name}});
  }
  return points;
}

// How far from rest every state is stable, in one direction of pressure.
double stable_until(const ResponseCurve& curve, double sign) {
  double until = 0;
  for (const State& state : curve.states()) {
    if (sign * state.pressure_kpa > 0 && state.stable) {
      until = sign * std::max(sign * until, sign * state.pressure_kpa);
    }
  }
  for (const State& state : curve.states()) {
    if (sign * state.pressure_kpa > 0 && !state.stable &&
        sign * state.pressure_kpa < sign * until) {
      until = state.pressure_kpa;
    }
  }
  for (const CriticalPoint& limit : curve.prediction.response.critical_points) {
    if (sign * limit.pressure_kpa > 0 && sign * limit.pressure_kpa < sign * until) {
      until = limit.pressure_kpa;
    }
  }
  return until;
}

Json kind_json(const KindPrediction& other, const Segment& segment, std::size_t index) {
  Json json{{"kind", word_of(other.kind, wall_kinds)}, {"states", Json::array()}};
  if (!other.prediction) {
    json["refusal"] = other.refusal;
    return json;
  }
  const Response& response = other.prediction->segments[index].response;
  json["message"] = response.message;
  for (const auto& state : response.states) {
    if (!state) continue;
    json["states"].push_back({{"pressure_kPa", state->pressure_kpa},
                              {"stretch", state->stretch},
                              {"twist_deg", twist_deg(*state, segment)},
                              {"bend_deg", bend_deg(*state, segment)}});
  }
  return json;
}

Json response_json(const ResponseCurve& curve, const Segment& segment, std::size_t number) {
  const Response& response = curve.prediction.response;
  return {{"segment", number},
          {"curve", curve_json(curve, segment)},
          {"band", band_json(curve.prediction, segment)},
          {"limit_points", limits_json(response)},
          {"turning_points", turning_json(response, segment)},
          {"stable_from_kPa", stable_until(curve, -1)},
          {"stable_to_kPa", stable_until(curve, 1)},
          {"message", response.message}};
}

// --- The chain
// ------------------------------------------------------------------------------------

Json point_json(const Point& point) {
  Json json = Json::array();
  for (const double x : point) json.push_back(std::round(x * 1e6) / 1e6);  // a nanometre will do
  return json;
}

Json case_json(const ChainResponse& chain, const Design& design, std::size_t i, int line_steps) {
  Json json{{"pressures_kPa", chain.cases[i].pressures_kpa}};
  const auto states = states_in(chain, i);
  json["exists"] = states.has_value();
  if (!states) return json;
  const Shape shape(design.segments, *states);
  const Frame tip = shape.tip();
  const Rotation& turn = tip.rotation;
  bool stable = true;
  for (const State& state : *states) stable = stable && state.stable;
  json["tip_mm"] = point_json(tip.origin);
  json["tip_axis"] = point_json({turn[0][2], turn[1][2], turn[2][2]});
  json["twist_deg"] = degrees(shape.end_rotation_rad());
  json["tilt_deg"] = degrees(tilt_rad(turn));
  json["length_mm"] = shape.length_mm();
  json["stable"] = stable;
  json["centre_line_mm"] = Json::array();
  for (const Point& point : shape.centre_line(line_steps)) {
    json["centre_line_mm"].push_back(point_json(point));
  }
  return json;
}

Json chain_json(const ReportCurves& curves, const Design& design) {
  const std::size_t lines = curves.chain.cases.size() * design.segments.size();
  const int steps = static_cast<int>(
      std::clamp<std::size_t>(most_line_points / std::max<std::size_t>(lines, 1), 2, 20));
  Json cases = Json::array();
  for (std::size_t i = 0; i < curves.chain.cases.size(); ++i) {
    cases.push_back(case_json(curves.chain, design, i, steps));
  }
  return {{"cases", cases}, {"cases_left_out", curves.cases_left_out}};
}

Json prediction_json(const ReportData& data) {
  if (!data.curves) return nullptr;
  Json segments = Json::array();
  for (std::size_t s = 0; s < data.curves->segments.size(); ++s) {
    const Segment& segment = data.design->segments[s];
    segments.push_back(response_json(data.curves->segments[s], segment, s + 1));
    if (data.curves->other_kinds.empty()) continue;
    Json& kinds = segments.back()["other_kinds"] = Json::array();
    for (const KindPrediction& other : data.curves->other_kinds) {
      kinds.push_back(kind_json(other, segment, s));
    }
  }
  return {{"segments", segments}, {"chain", chain_json(*data.curves, *data.design)}};
}

// --- What was made
// --------------------------------------------------------------------------------

Json piece_json(const ReportPiece& piece) {
  Json json{{"name", piece.name},
            {"kind", piece.kind},
            {"segment", piece.segment},
            {"files", piece.files},
            {"material", piece.material ? Json(piece.material->name) : Json(nullptr)},
            {"volume_mm3", piece.volume_mm3},
            {"mass_g", or_null(mass_g(piece))},
            {"prints", piece.prints}};
  const auto& mesh = piece.mesh;
  json["triangles"] = mesh ? Json(mesh->triangles) : Json(nullptr);
  json["components"] = mesh ? Json(mesh->components) : Json(nullptr);
  json["genus"] = mesh ? Json(mesh->genus) : Json(nullptr);
  json["size_mm"] = mesh ? Json(mesh->size_mm) : Json(nullptr);
  json["surface_error_mm"] = mesh ? Json(mesh->surface_error_mm) : Json(nullptr);
  json["volume_error_mm3"] = mesh ? Json(mesh->volume_error_mm3) : Json(nullptr);
  return json;
}

Json plan_json(const std::vector<ReportStage>& plan) {
  Json stages = Json::array();
  for (const ReportStage& stage : plan) {
    stages.push_back({{"stage", stage.name}, {"runs", stage.runs}, {"reason", stage.reason}});
  }
  return stages;
}

Json times_json(const std::vector<ReportTime>& times) {
  Json json = Json::array();
  for (const ReportTime& time : times) {
    json.push_back({{"stage", time.stage}, {"seconds", time.seconds}});
  }
  return json;
}

}  // namespace

std::optional<double> mass_g(const ReportPiece& piece) {
  if (!piece.material || !piece.material->density_g_per_cm3) return std::nullopt;
  return piece.volume_mm3 * 1e-3 * *piece.material->density_g_per_cm3;
}

std::string report_json(const ReportData& data, bool with_times) {
  Json json;
  json["schema"] = "latticast-report";
  json["schema_version"] = 1;
  json["program_version"] = data.program_version;
  json["name"] = data.design->name;
  json["design"] = design_json(*data.design);
  json["materials"] = materials_json(*data.design);
  json["plan"] = plan_json(data.plan);
  json["prediction"] = prediction_json(data);
  json["prediction_missing"] = data.curves_missing;
  json["checks"] = checks_json(data.findings);
  json["pieces"] = Json::array();
  for (const ReportPiece& piece : data.pieces) json["pieces"].push_back(piece_json(piece));
  json["files"] = data.files;
  if (with_times) json["times"] = times_json(data.times);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string response_csv(const ReportData& data) {
  if (!data.curves) return "";
  std::string text =
      "segment,pressure_kPa,asked,stretch,twist_deg,twist_per_length_rad_per_mm,bend_deg,"
      "bend_direction_deg,inner_radius_mm,outer_radius_mm,stable,residual,error_estimate\n";
  for (std::size_t s = 0; s < data.curves->segments.size(); ++s) {
    const ResponseCurve& curve = data.curves->segments[s];
    const Segment& segment = data.design->segments[s];
    for (std::size_t i = 0; i < curve.asked.size(); ++i) {
      const auto& state = curve.prediction.response.states[i];
      if (!state) continue;
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", s + 1, state->pressure_kpa,
                          curve.asked[i] ? 1 : 0, state->stretch, twist_deg(*state, segment),
                          state->twist_rad_per_mm / state->stretch, bend_deg(*state, segment),
                          degrees(state->bend_direction_rad()), state->inner_radius_mm,
                          state->outer_radius_mm, state->stable ? 1 : 0, state->residual,
                          state->error_estimate);
    }
  }
  return text;
}

}  // namespace latticast
