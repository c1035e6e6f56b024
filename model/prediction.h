// SPDX-License-Identifier: GPL-3.0-or-later
// Response of every segment of a design to its load.
#pragma once

#include <optional>
#include <vector>

#include "design/design.h"
#include "model/equilibrium/response.h"

namespace latticast {

/// One segment's answer. The bands are the same prediction with the liner's modulus at the ends of
/// the range in which its material is known; absent where the material states no range.
struct SegmentPrediction {
  std::vector<double> pressures_kpa;
  Response response;
  std::optional<Response> softest;
  std::optional<Response> stiffest;
};

/// How far the segment's far end is turned about its axis, right-handed about +z.
double twist_deg(const State& state, const Segment& segment);

/// By how much its far end is tilted: |kappa| L.
double bend_deg(const State& state, const Segment& segment);

struct Prediction {
  std::vector<SegmentPrediction> segments;

  bool complete() const;  ///< every requested state exists
};

/// The design's load cases; with `pressures_kpa`, those instead, each applied to every segment.
/// Throws std::invalid_argument when there is no load at all.
std::vector<LoadCase> asked_cases(const Design& design, const std::vector<double>& pressures_kpa);

/// One segment's pressures in asked_cases: distinct ones, in the order in which they first appear.
std::vector<double> segment_pressures_kpa(const Design& design, std::size_t segment,
                                          const std::vector<double>& pressures_kpa);

/// Predicts every segment at its segment_pressures_kpa; equal ones are predicted once. Throws
/// UnsupportedDesign, and std::invalid_argument when there is no load at all.
Prediction predict_design(const Design& design, const std::vector<double>& pressures_kpa, Held held,
                          bool with_bands);

}  // namespace latticast
