// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/predict_command.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/design_input.h"
#include "app/prediction.h"
#include "app/prediction_output.h"
#include "app/pressure_list.h"

namespace latticast {
namespace {

Held held_coordinates(const std::vector<std::string>& names) {
  Held held;
  for (const std::string& name : names) {
    if (name == "twist") held.twist = true;
    if (name == "stretch") held.stretch = true;
    if (name == "bend") held.bend = true;
  }
  return held;
}

void add_messages(const Prediction& prediction, const Console& console) {
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    const Response& response = prediction.segments[s].response;
    for (const TurningPoint& point : response.turning_points) {
      console.note(fmt::format("segment {}: {}", s + 1, point.name));
    }
    if (response.message.empty()) continue;
    const std::string line = fmt::format("segment {}: {}", s + 1, response.message);
    response.status == Status::ok ? console.note(line) : console.error(line);
  }
}

// MODEL.md section 9 measured how far this kind of model is from a three-dimensional calculation.
void note_known_bias(const Design& design, const Console& console) {
  const bool reinforced =
      std::any_of(design.segments.begin(), design.segments.end(),
                  [](const Segment& segment) { return segment.lattice.has_value(); });
  if (!reinforced) return;
  console.note(
      "known bias: against a 3-D finite-element cell (36 degrees, 8 strips), stretch - 1 comes "
      "out 18-28 % and twist 7-20 % too high with joint = \"clear-span\" (docs/model.md)");
}

}  // namespace

ExitStatus run_predict(const PredictArguments& arguments, const Console& console) {
  const auto materials = load_materials(arguments.materials, console);
  if (!materials) return ExitStatus::invalid;
  std::vector<double> pressures;
  if (!arguments.pressure.empty()) pressures = parse_pressures_kpa(arguments.pressure);
  const auto design = load_design(arguments.design, *materials, console);
  if (!design) return ExitStatus::invalid;

  const Held held = held_coordinates(arguments.hold);
  const bool with_bands = arguments.format != "csv";
  const Prediction prediction = predict_design(*design, pressures, held, with_bands);
  if (arguments.format == "csv") {
    console.data(prediction_csv(*design, prediction, held));
  } else if (arguments.format == "json") {
    console.data(prediction_json(*design, prediction, held));
  } else {
    console.data(prediction_table(*design, prediction, held));
    note_known_bias(*design, console);
  }
  add_messages(prediction, console);
  return prediction.complete() ? ExitStatus::done : ExitStatus::no_equilibrium;
}

}  // namespace latticast
