// SPDX-License-Identifier: GPL-3.0-or-later
// Error of each kind of model against its processor time: six pressures of two twisting lattices,
// against a finite-element mesh of 19 838 unknowns (tests/golden/fe_cell_twist.csv).
//   model_kinds  for the page and its plot
#include <string>
#include <vector>

#include "bench/study.h"
#include "model/segment_response.h"
#include "tests/golden/fe_cell_twist.h"
#include "tests/unit/model/segments.h"

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
}
