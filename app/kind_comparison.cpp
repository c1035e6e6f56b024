// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kind_comparison.h"

#include <algorithm>
#include <ctime>

#include <fmt/core.h>

#include "app/answer_json.h"
#include "design/text/written_number.h"
#include "model/kind_prediction.h"

namespace latticast {
namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// As names of columns begin.
std::string key_of(WallKind kind) {
  std::string key(word_of(kind, wall_kinds));
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

void add_notes(const KindPrediction& one, double seconds, std::vector<std::string>& notes) {
  const std::string_view name = word_of(one.kind, wall_kinds);
  if (!one.prediction) {
    notes.push_back(fmt::format("{} is left out: {}", name, one.refusal));
    return;
  }
  notes.push_back(fmt::format("{}: {} s", name, written(seconds, 2)));
  for (std::size_t s = 0; s < one.prediction->segments.size(); ++s) {
    const std::string& message = one.prediction->segments[s].response.message;
    if (!message.empty()) {
      notes.push_back(fmt::format("{}, segment {}: {}", name, s + 1, message));
    }
  }
}

/// A row where every kind has a state, else why it is missing.
void add_row(const std::vector<KindPrediction>& known, const Design& design, std::size_t segment,
             std::size_t at, NumberRows& numbers) {
  const SegmentPrediction& first = known.front().prediction->segments[segment];
  const double pressure = first.pressures_kpa[at];
  std::vector<double> row = {static_cast<double>(segment + 1), pressure};
  MissingRow missing{{{"segment", row[0]}, {"pressure_kPa", pressure}}, {}};
  for (const KindPrediction& one : known) {
    const Response& response = one.prediction->segments[segment].response;
    const auto& state = response.states[at];
    if (state) {
      row.insert(row.end(), {state->stretch, twist_deg(*state, design.segments[segment]),
                             bend_deg(*state, design.segments[segment])});
      continue;
    }
    if (!missing.reason.empty()) missing.reason += "; ";
    missing.reason +=
        fmt::format("{}: {}", word_of(one.kind, wall_kinds), reason_of(response, pressure));
  }
  if (missing.reason.empty()) {
    numbers.rows.push_back(std::move(row));
  } else {
    numbers.missing.push_back(std::move(missing));
  }
}

}  // namespace

KindComparison compare_kinds(const Design& design, const std::vector<double>& pressures_kpa,
                             Held held) {
  KindComparison result;
  std::vector<KindPrediction> known;
  result.numbers.columns = {"segment", "pressure_kPa"};
  for (const WallKind kind : compared_kinds) {
    const double start = processor_seconds();
    KindPrediction one = predict_kind(design, kind, pressures_kpa, held);
    add_notes(one, processor_seconds() - start, result.notes);
    if (!one.prediction) continue;
    for (const char* quantity : {"stretch", "twist_deg", "bend_deg"}) {
      result.numbers.columns.push_back(fmt::format("{}_{}", key_of(kind), quantity));
    }
    result.complete = result.complete && one.prediction->complete();
    known.push_back(std::move(one));
  }
  if (known.empty()) result.complete = false;
  for (std::size_t s = 0; s < design.segments.size() && !known.empty(); ++s) {
    const std::size_t count = known.front().prediction->segments[s].pressures_kpa.size();
    for (std::size_t i = 0; i < count; ++i) add_row(known, design, s, i, result.numbers);
  }
  return result;
}

}  // namespace latticast
