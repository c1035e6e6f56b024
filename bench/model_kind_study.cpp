// SPDX-License-Identifier: GPL-3.0-or-later
// Error of each kind of model against its processor time: six pressures of two twisting lattices,
// against a finite-element mesh of 19 838 unknowns (tests/golden/fe_cell_twist.csv).
//   model_kinds  for the page and its plot
// And of columns that elongate and bend, against their unit cell, refined where it elongates:
//   model_kinds_columns
#include <string>
#include <utility>
#include <vector>

#include "bench/study.h"
#include "model/segment_response.h"
#include "tests/golden/fe_cell_twist.h"
#include "tests/unit/model/cell/waves.h"

namespace {

using namespace latticast;

struct Kind {
  std::string name;
  ModelChoice model;
};

ModelChoice choice(WallKind wall, Calibrate calibrate = Calibrate::nothing) {
  ModelChoice model;
  model.wall = wall;
  model.calibrate = calibrate;
  return model;
}

std::vector<Cell> row_of(const Kind& kind) {
  testing::Deviation stretch;
  testing::Deviation twist;
  double preparing = 0;
  double solving = 0;
  const std::vector<double> angles = {36, 60};
  for (const double angle : angles) {
    const std::vector<testing::CellRow> truth = testing::finite_element_rows(angle);
    std::vector<double> pressures;
    pressures.reserve(truth.size());
    for (const testing::CellRow& row : truth) pressures.push_back(row.pressure_kpa);
    const Segment segment = testing::twisting_segment(angle);
    const PreparedSegment prepared = prepare_segment(segment, kind.model);
    const Response response = predict(prepared, pressures);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const State& state = response.states[i].value();
      stretch.add(state.stretch - 1, truth[i].stretch - 1);
      twist.add(state.twist_rad_per_mm, truth[i].twist_rad_per_mm);
    }
    preparing += processor_seconds([&] { prepare_segment(segment, kind.model); });
    solving += processor_seconds([&] { predict(prepared, pressures); });
  }
  const auto lattices = static_cast<double>(angles.size());
  return {kind.name,
          stretch.mean(),
          stretch.worst,
          twist.mean(),
          twist.worst,
          1e3 * preparing / lattices,
          1e3 * solving / lattices};
}

/// A segment of columns, and its states by the unit cell.
struct Columns {
  Segment segment;
  std::vector<State> truth;
};

const std::vector<double>& column_pressures() {
  static const std::vector<double> pressures = {10, 20, 30};
  return pressures;
}

Columns columns(Segment segment, double error_percent) {
  ModelChoice model = choice(WallKind::unit_cell);
  model.cell_error_percent = error_percent;
  Columns result{std::move(segment), {}};
  for (const auto& state : predict(result.segment, model, column_pressures()).states) {
    result.truth.push_back(state.value());
  }
  return result;
}

struct ColumnsDeviation {
  testing::Deviation stretch;
  testing::Deviation angle;  // of twist, or of bending
  double seconds = 0;
};

ColumnsDeviation deviation(const Columns& columns, const ModelChoice& model) {
  ColumnsDeviation result;
  Response response;
  result.seconds =
      processor_seconds([&] { response = predict(columns.segment, model, column_pressures()); });
  for (std::size_t i = 0; i < columns.truth.size(); ++i) {
    const State& truth = columns.truth[i];
    const State& state = response.states[i].value();
    result.stretch.add(state.stretch - 1, truth.stretch - 1);
    if (truth.twist_rad_per_mm != 0) {
      result.angle.add(state.twist_rad_per_mm, truth.twist_rad_per_mm);
    }
    if (truth.bend_magnitude_rad_per_mm() != 0) {
      result.angle.add(state.bend_magnitude_rad_per_mm(), truth.bend_magnitude_rad_per_mm());
    }
  }
  return result;
}

void write_columns(const std::vector<Kind>& kinds, const std::filesystem::path& folder) {
  const Columns bulges = columns(testing::elongating(0.25), 0.5);
  const Columns junctions = columns(testing::elongating(0.5), 0.5);
  const Columns bending = columns(testing::waves(testing::halves(16, 2.5, 2), 0.25), 0);
  StudyTable table(
      "model_kinds_columns",
      {"kind", "rings on bulges: stretch - 1 (%)", "time (ms)", "on junctions: stretch - 1 (%)",
       "twist (%)", "time (ms)", "bending 2:2.5: stretch - 1 (%)", "bending (%)", "time (ms)"});
  for (const Kind& kind : kinds) {
    const ColumnsDeviation a = deviation(bulges, kind.model);
    const ColumnsDeviation b = deviation(junctions, kind.model);
    const ColumnsDeviation c = deviation(bending, kind.model);
    table.add({kind.name, a.stretch.worst, 1e3 * a.seconds, b.stretch.worst, b.angle.worst,
               1e3 * b.seconds, c.stretch.worst, c.angle.worst, 1e3 * c.seconds});
  }
  table.write(folder);
}

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  const std::vector<Kind> kinds = {
      {"layered", choice(WallKind::layered)},
      {"bonded uncalibrated", choice(WallKind::bonded)},
      {"bonded", choice(WallKind::bonded, Calibrate::stiffness)},
      {"bonded with a state", choice(WallKind::bonded, Calibrate::state)},
      {"unit cell", choice(WallKind::unit_cell)}};
  StudyTable table("model_kinds", {"kind", "stretch - 1, mean (%)", "worst (%)", "twist, mean (%)",
                                   "worst (%)", "set-up (ms)", "6 pressures (ms)"});
  for (const Kind& kind : kinds) table.add(row_of(kind));
  table.write(folder);
  // Bonding says nothing of curved strands by itself.
  write_columns({kinds[0], kinds[2], kinds[3], kinds[4]}, folder);
}
