// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/kind_prediction.h"

#include "design/unsupported_design.h"

namespace latticast {

KindPrediction predict_kind(const Design& design, WallKind kind,
                            const std::vector<double>& pressures_kpa, Held held) {
  Design asked = design;
  asked.model.wall = kind;
  KindPrediction result{kind, {}, {}};
  try {
    result.prediction = predict_design(asked, pressures_kpa, held, false);
  } catch (const UnsupportedDesign& problem) {
    result.refusal = problem.what();
  }
  return result;
}

}  // namespace latticast
