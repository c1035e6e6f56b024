// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/prediction.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "design/units.h"
#include "model/prepared_segment.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

std::optional<Response> predict_scaled(PreparedSegments& prepared, Segment segment,
                                       const std::vector<double>& pressures, Held held,
                                       std::optional<double> factor) {
  if (!factor) return std::nullopt;
  segment.liner.material.law = scaled(segment.liner.material.law, *factor);
  return predict(prepared.prepare(segment), pressures, held);
}

SegmentPrediction predict_segment(PreparedSegments& prepared, const Segment& segment,
                                  const std::vector<double>& pressures_kpa, Held held,
                                  bool with_bands) {
  SegmentPrediction result{
      pressures_kpa, predict(prepared.prepare(segment), pressures_kpa, held), {}, {}};
  if (!with_bands) return result;
  const Material& liner = segment.liner.material;
  result.softest = predict_scaled(prepared, segment, pressures_kpa, held, liner.modulus_low_factor);
  result.stiffest =
      predict_scaled(prepared, segment, pressures_kpa, held, liner.modulus_high_factor);
  return result;
}

/// The number of an earlier segment with the same answer, or the segment's own.
std::size_t first_alike(const Design& design, const Prediction& earlier, std::size_t segment,
                        const std::vector<double>& pressures_kpa) {
  for (std::size_t i = 0; i < segment; ++i) {
    if (design.segments[i] == design.segments[segment] &&
        earlier.segments[i].pressures_kpa == pressures_kpa) {
      return i;
    }
  }
  return segment;
}

}  // namespace

double twist_deg(const State& state, const Segment& segment) {
  return degrees(state.twist_rad_per_mm * segment.length_mm);
}

double bend_deg(const State& state, const Segment& segment) {
  return degrees(state.bend_magnitude_rad_per_mm() * segment.length_mm);
}

bool Prediction::complete() const {
  return std::all_of(segments.begin(), segments.end(), [](const SegmentPrediction& segment) {
    return segment.response.status == Status::ok;
  });
}

std::vector<LoadCase> asked_cases(const Design& design, const std::vector<double>& pressures_kpa) {
  if (pressures_kpa.empty() && design.load.empty()) {
    throw std::invalid_argument(
        "no pressure to predict for: give --pressure FROM:TO:STEP, or add "
        "[load] pressure = { from = 0, to = 40, step = 5 } to the design");
  }
  if (pressures_kpa.empty()) return design.load;
  std::vector<LoadCase> cases;
  cases.reserve(pressures_kpa.size());
  for (const double pressure : pressures_kpa) {
    cases.push_back({std::vector<double>(design.segments.size(), pressure)});
  }
  return cases;
}

std::vector<double> segment_pressures_kpa(const Design& design, std::size_t segment,
                                          const std::vector<double>& pressures_kpa) {
  std::vector<double> pressures;
  std::set<double> seen;
  for (const LoadCase& load : asked_cases(design, pressures_kpa)) {
    const double pressure = load.pressures_kpa[segment];
    if (seen.insert(pressure).second) pressures.push_back(pressure);
  }
  return pressures;
}

Prediction predict_design(const Design& design, const std::vector<double>& pressures_kpa, Held held,
                          bool with_bands) {
  PreparedSegments prepared(design.model);
  Prediction prediction;
  for (std::size_t i = 0; i < design.segments.size(); ++i) {
    const std::vector<double> pressures = segment_pressures_kpa(design, i, pressures_kpa);
    const std::size_t alike = first_alike(design, prediction, i, pressures);
    SegmentPrediction answer =
        alike < i ? prediction.segments[alike]
                  : predict_segment(prepared, design.segments[i], pressures, held, with_bands);
    prediction.segments.push_back(std::move(answer));
  }
  return prediction;
}

}  // namespace latticast
