// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/segment_response.h"

#include <cmath>
#include <stdexcept>

#include "model/calibrated_response.h"
#include "model/cell/unit_cell.h"
#include "model/effective_rods/rods_response.h"
#include "model/equilibrium/branch_text.h"
#include "model/section_response.h"

namespace latticast {
namespace {

void add_assumption(const PreparedSegment& segment, Response& response) {
  if (!segment.cell || segment.cell->assumed.empty()) return;
  add_sentence(response.message, segment.cell->assumed);
}

}  // namespace

Response predict(const PreparedSegment& segment, std::span<const double> pressures_kpa, Held held,
                 const SolverOptions& options) {
  for (const double pressure : pressures_kpa) {
    if (!std::isfinite(pressure)) throw std::invalid_argument("a pressure is not a finite number");
  }
  if (const auto* rods = std::get_if<Rods>(&segment.section)) {
    Response response;
    response.states.resize(pressures_kpa.size());
    response.laws = laws_of(segment);
    predict_rods(*rods, segment.length_mm, pressures_kpa, held, response);
    return response;
  }
  if (segment.calibrate != Calibrate::nothing) {
    Response response = calibrated_response(segment, pressures_kpa, held, options);
    add_assumption(segment, response);
    return response;
  }
  const SectionPath path{std::get<Section>(segment.section), segment.cell.get(), segment.length_mm};
  Response response = section_response(path, pressures_kpa, held, options);
  add_assumption(segment, response);
  if (!segment.not_calibrated.empty()) {
    add_sentence(response.message, "not calibrated: " + segment.not_calibrated);
  }
  return response;
}

Response predict(const Segment& segment, const ModelChoice& model,
                 std::span<const double> pressures_kpa, Held held, const SolverOptions& options) {
  return predict(prepare_segment(segment, model), pressures_kpa, held, options);
}

}  // namespace latticast
