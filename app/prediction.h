// SPDX-License-Identifier: GPL-3.0-or-later
// The predicted response of every segment of a design to its load.
#pragma once

#include <optional>
#include <vector>

#include "model/response.h"
#include "spec/design.h"

namespace latticast {

/// One segment's answer. The bands are the same prediction with the liner's modulus at the ends of
/// the range in which its material is known; absent where the material states no range.
struct SegmentPrediction {
  std::vector<double> pressures_kpa;
  Response response;
  std::optional<Response> softest;
  std::optional<Response> stiffest;
};

struct Prediction {
  std::vector<SegmentPrediction> segments;

  bool complete() const;  ///< every requested state exists
};

/// Predicts all segments. `pressures_kpa`, when not empty, replaces the design's load and applies
/// to every segment. Throws UnsupportedDesign, and std::invalid_argument when there is no load at
/// all.
Prediction predict_design(const Design& design, const std::vector<double>& pressures_kpa, Held held,
                          bool with_bands);

}  // namespace latticast
