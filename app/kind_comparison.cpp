// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kind_comparison.h"

#include <algorithm>
#include <array>
#include <ctime>

#include <fmt/core.h>

#include "app/answer_json.h"
#include "design/text/written_number.h"
#include "design/unsupported_design.h"
#include "model/prediction.h"

namespace latticast {
namespace {

struct Kind {
  const char* name = "";
  const char* key = "";  // in the names of columns
  WallKind wall = WallKind::layered;
};
constexpr std::array kinds = {Kind{"layered", "layered", WallKind::layered},
                              Kind{"bonded", "bonded", WallKind::bonded},
                              Kind{"unit-cell", "unit_cell", WallKind::unit_cell}};

struct KindPrediction {
  const Kind* kind = nullptr;
  Prediction prediction;
};

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void predict_kind(const Design& design, const Kind& kind, const std::vector<double>& pressures_kpa,
                  Held held, std::vector<KindPrediction>& predictions,
                  std::vector<std::string>& notes) {
  Design asked = design;
  asked.model.wall = kind.wall;
  const double start = processor_seconds();
  try {
    predictions.push_back({&kind, predict_design(asked, pressures_kpa, held, false)});
  } catch (const UnsupportedDesign& problem) {
    notes.push_back(fmt::format("{} is left out: {}", kind.name, problem.what()));
    return;
  }
  notes.push_back(fmt::format("{}: {} s", kind.name, written(processor_seconds() - start, 2)));
  const Prediction& prediction = predictions.back().prediction;
  for (std::size_t s = 0; s < prediction.segments.size(); ++s) {
    const std::string& message = prediction.segments[s].response.message;
    if (!message.empty()) {
      notes.push_back(fmt::format("{}, segment {}: {}", kind.name, s + 1, message));
    }
  }
}

}  // namespace

KindComparison compare_kinds(const Design& design, const std::vector<double>& pressures_kpa,
                             Held held) {
  KindComparison result;
  std::vector<KindPrediction> predictions;
  for (const Kind& kind : kinds) {
    predict_kind(design, kind, pressures_kpa, held, predictions, result.notes);
  }
  result.numbers.columns = {"segment", "pressure_kPa"};
  for (const KindPrediction& one : predictions) {
    for (const char* quantity : {"stretch", "twist_deg", "bend_deg"}) {
      result.numbers.columns.push_back(fmt::format("{}_{}", one.kind->key, quantity));
    }
  }
  if (predictions.empty()) return {std::move(result.numbers), std::move(result.notes), false};
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    const std::vector<double>& pressures = predictions.front().prediction.segments[s].pressures_kpa;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      std::vector<double> row = {static_cast<double>(s + 1), pressures[i]};
      bool has_all = true;
      MissingRow missing{{{"segment", row[0]}, {"pressure_kPa", row[1]}}, {}};
      for (const KindPrediction& one : predictions) {
        const auto& state = one.prediction.segments[s].response.states[i];
        has_all = has_all && state.has_value();
        if (!state) {
          missing.reason +=
              fmt::format("{}{}: {}", missing.reason.empty() ? "" : "; ", one.kind->name,
                          reason_of(one.prediction.segments[s].response, pressures[i]));
          continue;
        }
        row.insert(row.end(), {state->stretch, twist_deg(*state, design.segments[s]),
                               bend_deg(*state, design.segments[s])});
      }
      if (has_all) {
        result.numbers.rows.push_back(std::move(row));
      } else {
        result.numbers.missing.push_back(std::move(missing));
      }
      result.complete = result.complete && has_all;
    }
  }
  return result;
}

}  // namespace latticast
