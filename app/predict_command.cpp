// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/predict_command.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/core.h>

#include "app/answer_json.h"
#include "app/chain_output.h"
#include "app/kind_comparison.h"
#include "app/prediction_output.h"
#include "app/pressure_list.h"
#include "app/tip_force_output.h"
#include "app/wall_output.h"
#include "files/atomic_file.h"
#include "geometry/pattern/drawing_problems.h"
#include "model/prediction.h"

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

void add_messages(const Response& response, std::size_t segment, const Console& console) {
  for (const AngleExtremum& point : response.angle_extrema) {
    console.note(fmt::format("segment {}: {}", segment + 1, point.name));
  }
  if (response.message.empty()) return;
  const std::string line = fmt::format("segment {}: {}", segment + 1, response.message);
  response.status == Status::ok ? console.note(line) : console.error(line);
}

// Measured against three-dimensional calculations: docs/model.md#what-it-leaves-out,
// docs/bonded.md#accuracy and docs/unit-cell.md#any-lattice. Empty where none is worth a note.
std::string_view known_bias(const ModelChoice& model, bool has_columns) {
  if (model.wall == WallKind::unit_cell) return {};
  if (model.wall != WallKind::bonded) {
    return has_columns
               ? "known bias: against 3-D finite-element cells of columns, stretch - 1 comes out "
                 "39-127 % too high, depending on where rings sit on the waves, and bending 15-51 "
                 "% "
                 "(docs/unit-cell.md); kind = \"bonded\" corrects it"
               : "known bias: against a 3-D finite-element cell (36 degrees, 8 strips), stretch - "
                 "1 "
                 "comes out 18-28 % and twist 7-20 % too high with joint = \"clear-span\" "
                 "(docs/model.md); kind = \"bonded\" corrects it";
  }
  if (model.calibrate != Calibrate::nothing) return {};
  return "known bias: against finite-element cells with rings 6 to 10 mm apart, stretch - 1 comes "
         "out up to 16 % and twist up to 19 % off (docs/bonded.md); calibrate = true corrects it";
}

bool has_columns(const Segment& segment) {
  return segment.lattice && has_curved_strands(*segment.lattice);
}

void note_known_bias(const Design& design, const Console& console) {
  const bool reinforced =
      std::any_of(design.segments.begin(), design.segments.end(),
                  [](const Segment& segment) { return segment.lattice.has_value(); });
  const std::string_view bias = known_bias(
      design.model, std::any_of(design.segments.begin(), design.segments.end(), has_columns));
  if (reinforced && !bias.empty()) console.note(bias);
}

/// What is predicted is not what can be drawn, or would be.
void note_drawing(const Design& design, const Console& console) {
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    for (const std::string& problem : drawing_problems(design.segments[s])) {
      console.note(
          fmt::format("segment {} cannot be drawn as it is predicted: {}", s + 1, problem));
    }
    if (design.model.wall == WallKind::unit_cell) continue;
    for (const std::string& overlap : overlapping_neighbours(design.segments[s])) {
      console.note(fmt::format(
          "segment {}: {}. They are drawn as one net, and predicted as if each were by itself; "
          "kind = \"unit-cell\" predicts the net",
          s + 1, overlap));
    }
  }
}

void deliver(const std::string& answer, const PredictArguments& arguments, const Console& console) {
  if (arguments.output.empty() || arguments.output == "-") {
    console.data(answer);
    return;
  }
  write_file_atomically(arguments.output, answer);
  console.note(fmt::format("wrote {}", arguments.output.string()));
}

void deliver_rows(const Design& design, std::string_view answer, const NumberRows& rows,
                  const PredictArguments& arguments, const Console& console) {
  deliver(arguments.format == "json"  ? rows_json(design, answer, rows)
          : arguments.format == "csv" ? rows_as_csv(rows)
                                      : rows_as_table(rows),
          arguments, console);
}

std::string format_of(const std::filesystem::path& output) {
  const std::string suffix = output.extension().string();
  return suffix == ".csv" || suffix == ".json" ? suffix.substr(1) : "table";
}

ExitStatus predict_responses(const Design& design, const PredictArguments& arguments,
                             const std::vector<double>& pressures, const Console& console) {
  const Held held = held_coordinates(arguments.hold);
  const bool with_bands = arguments.format != "csv";
  const Prediction prediction = predict_design(design, pressures, held, with_bands);
  if (arguments.format == "csv") {
    deliver(prediction_csv(design, prediction, held, arguments.times), arguments, console);
  } else if (arguments.format == "json") {
    deliver(response_json(design, prediction, held, arguments.times), arguments, console);
  } else {
    deliver(prediction_table(design, prediction, held), arguments, console);
    note_known_bias(design, console);
  }
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    add_messages(prediction.segments[s].response, s, console);
  }
  return prediction.complete() ? ExitStatus::done : ExitStatus::no_equilibrium;
}

ExitStatus predict_shapes(const Design& design, const PredictArguments& arguments,
                          const std::vector<double>& pressures, const Console& console) {
  const ChainResponse chain =
      predict_chain(design.segments, design.model, asked_cases(design, pressures));
  NumberRows rows = arguments.shape == "tip" ? tip_rows(chain, design.segments)
                                             : centre_line_rows(chain, design.segments);
  rows.missing = missing_cases(chain);
  deliver_rows(design, arguments.shape, rows, arguments, console);
  bool complete = true;
  for (std::size_t s = 0; s < chain.responses.size(); ++s) {
    add_messages(chain.responses[s], s, console);
    complete = complete && chain.responses[s].status == Status::ok;
  }
  console.note(reach_summary(chain, design.segments));
  return complete ? ExitStatus::done : ExitStatus::no_equilibrium;
}

ExitStatus predict_blocked_tip(const Design& design, const PredictArguments& arguments,
                               const std::vector<double>& pressures, const Console& console) {
  const TipForceAnswer answer = predict_tip_forces(design, pressures);
  deliver_rows(design, "tip-force", answer.numbers, arguments, console);
  if (answer.complete) return ExitStatus::done;
  console.error(
      "some pressures have no row: the free segment has no stable equilibrium there (latticast "
      "predict names the limit), or the one against the stop was not found");
  return ExitStatus::no_equilibrium;
}

ExitStatus predict_by_kinds(const Design& design, const PredictArguments& arguments,
                            const std::vector<double>& pressures, const Console& console) {
  const KindComparison comparison =
      compare_kinds(design, pressures, held_coordinates(arguments.hold));
  deliver_rows(design, "kinds", comparison.numbers, arguments, console);
  for (const std::string& note : comparison.notes) console.note(note);
  if (comparison.complete) return ExitStatus::done;
  console.error("some pressures have no row: not every kind has a state there");
  return ExitStatus::no_equilibrium;
}

ExitStatus predict_by_walls(const Design& design, const PredictArguments& arguments,
                            const std::vector<double>& pressures, const Console& console) {
  const NumberRows numbers = predict_walls(design, pressures);
  deliver_rows(design, "wall", numbers, arguments, console);
  if (numbers.missing.empty()) return ExitStatus::done;
  console.error("some pressures have no row: latticast predict names why");
  return ExitStatus::no_equilibrium;
}

bool holds_tip(const PredictArguments& arguments) {
  const std::vector<std::string>& held = arguments.hold;
  const bool tip = std::find(held.begin(), held.end(), "tip") != held.end();
  if (tip && held.size() > 1) {
    throw std::invalid_argument(
        "--hold tip keeps the tip's place, the other words a coordinate of every section: ask for "
        "one after the other");
  }
  if (arguments.kinds && (tip || arguments.wall || !arguments.shape.empty())) {
    throw std::invalid_argument(
        "--kinds compares the responses of segments: leave --shape, --wall and --hold tip out");
  }
  if (arguments.wall && (!held.empty() || !arguments.shape.empty())) {
    throw std::invalid_argument("--wall shows free segments: leave --shape and --hold out");
  }
  if (!held.empty() && !arguments.shape.empty()) {
    throw std::invalid_argument("--shape shows free actuators: leave --hold out");
  }
  return tip;
}

}  // namespace

ExitStatus run_predict(const PredictArguments& asked, const Console& console) {
  PredictArguments arguments = asked;
  if (arguments.format.empty()) arguments.format = format_of(arguments.output);
  const bool blocked_tip = holds_tip(arguments);
  std::vector<double> pressures;
  if (arguments.pressure) pressures = parse_pressures_kpa(*arguments.pressure);
  const auto design = load_design(arguments.design, console);
  if (!design) return ExitStatus::invalid;
  note_drawing(*design, console);
  if (blocked_tip) return predict_blocked_tip(*design, arguments, pressures, console);
  if (!arguments.shape.empty()) return predict_shapes(*design, arguments, pressures, console);
  if (arguments.wall) return predict_by_walls(*design, arguments, pressures, console);
  if (arguments.kinds) return predict_by_kinds(*design, arguments, pressures, console);
  return predict_responses(*design, arguments, pressures, console);
}

}  // namespace latticast
