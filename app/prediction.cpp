// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/prediction.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace latticast {
namespace {

// Every law here is proportional to its moduli.
Law scaled(Law law, double factor) {
  std::visit(
      [factor](auto& l) {
        using L = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<L, Linear>) {
          l.youngs_modulus_mpa *= factor;
        } else if constexpr (std::is_same_v<L, Yeoh>) {
          l.c1_mpa *= factor;
          l.c2_mpa *= factor;
          l.c3_mpa *= factor;
        } else {
          l.shear_modulus_mpa *= factor;
        }
      },
      law);
  return law;
}

std::optional<Response> predict_scaled(Segment segment, const Design& design,
                                       const std::vector<double>& pressures, Held held,
                                       std::optional<double> factor) {
  if (!factor) return std::nullopt;
  segment.liner.material.law = scaled(segment.liner.material.law, *factor);
  return predict(segment, design.model, pressures, held);
}

std::vector<double> load_of(const Design& design, std::size_t segment) {
  std::vector<double> pressures;
  for (const LoadCase& load : design.load) pressures.push_back(load.pressures_kpa[segment]);
  return pressures;
}

}  // namespace

bool Prediction::complete() const {
  return std::all_of(segments.begin(), segments.end(), [](const SegmentPrediction& segment) {
    return segment.response.status == Status::ok;
  });
}

Prediction predict_design(const Design& design, const std::vector<double>& pressures_kpa, Held held,
                          bool with_bands) {
  if (pressures_kpa.empty() && design.load.empty()) {
    throw std::invalid_argument(
        "no pressure to predict for: give --pressure FROM:TO:STEP, or add "
        "[load] pressure = { from = 0, to = 40, step = 5 } to the design");
  }
  Prediction prediction;
  for (std::size_t i = 0; i < design.segments.size(); ++i) {
    const Segment& segment = design.segments[i];
    const std::vector<double> pressures =
        pressures_kpa.empty() ? load_of(design, i) : pressures_kpa;
    SegmentPrediction result{pressures, predict(segment, design.model, pressures, held), {}, {}};
    if (with_bands) {
      const Material& liner = segment.liner.material;
      result.softest = predict_scaled(segment, design, pressures, held, liner.modulus_low_factor);
      result.stiffest = predict_scaled(segment, design, pressures, held, liner.modulus_high_factor);
    }
    prediction.segments.push_back(std::move(result));
  }
  return prediction;
}

}  // namespace latticast
