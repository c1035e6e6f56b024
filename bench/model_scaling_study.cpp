// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory of prediction as a design grows.
//   model_scaling_fits  for the page: fitted exponents
//   model_scaling       every point of the plot
// Each point runs in a process of its own; memory is what it needs beyond an idle one.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bench/study.h"
#include "model/chain.h"
#include "model/segment_response.h"
#include "model/shape/shape.h"
#include "tests/unit/model/segments.h"

namespace {

using namespace latticast;

/// One way to grow: `run` does the work for a size.
struct Stage {
  std::string name;
  std::vector<int> sizes;
  std::function<void(int)> run;
};

std::vector<int> decades(int first, int last) {
  std::vector<int> sizes;
  for (int half = 0; sizes.empty() || sizes.back() < last; ++half) {
    sizes.push_back(static_cast<int>(std::lround(first * std::pow(10, 0.5 * half))));
  }
  return sizes;
}

std::vector<int> doublings(int first, int last) {
  std::vector<int> sizes;
  for (int size = first; size <= last; size *= 4) sizes.push_back(size);
  if (sizes.back() != last) sizes.push_back(last);
  return sizes;
}

const std::vector<double> one_pressure = {20};

std::vector<double> pressures(int count, double highest_kpa) {
  std::vector<double> result(count);
  for (int i = 0; i < count; ++i) result[i] = highest_kpa * (i + 1) / count;
  return result;
}

void predict_all(const Segment& segment, const std::vector<double>& pressures_kpa) {
  predict(segment, {}, pressures_kpa);
}

/// Wide strands on one half of the tube: the section bends, every strand counts on its own.
void uneven_straight(int strands) {
  Segment segment = testing::paper_segment({});
  const double share = 0.4 * 2 * pi * 17 / strands;
  segment.lattice->grids.push_back({90, testing::halves(strands, share, share / 2), {}});
  predict_all(segment, one_pressure);
}

void uneven_horseshoes(int strands) {
  predict_all(testing::columns(testing::halves(strands, 2, 1)), one_pressure);
}

/// Two odd strands at the end of the list, so that every place may be a mirror's for long.
void nearly_even(int strands) {
  std::vector<double> widths(strands, 20.0 / strands);
  widths[strands - 1] *= 2;
  widths[strands - 3] *= 1.5;
  Segment segment = testing::paper_segment({});
  segment.lattice->grids.push_back({90, widths, {}});
  prepare_segment(segment, {});
}

void families(int count) {
  Segment segment = testing::paper_segment({});
  for (int i = 0; i < count; ++i) {
    segment.lattice->grids.push_back(testing::grid(20 + 60.0 * i / count, 4, 1.0 / count));
  }
  predict_all(segment, one_pressure);
}

void distinct_laws(int count) {
  std::vector<double> widths(count);
  for (int i = 0; i < count; ++i) widths[i] = 2 + 1.0 * i / count;
  prepare_segment(testing::columns(widths), {});
}

void many_pressures(int count) {
  predict_all(testing::paper_segment({36}), pressures(count, 60));
}

std::vector<LoadCase> cases(int count, int segments) {
  std::vector<LoadCase> result(count);
  for (int i = 0; i < count; ++i) result[i].pressures_kpa.assign(segments, 20.0 * (i + 1) / count);
  return result;
}

void many_segments(int count) {
  const std::vector<Segment> chain(count, testing::columns(testing::halves(8, 3.5, 2)));
  const auto load = cases(1, count);
  shape_in(predict_chain(chain, {}, load), chain, 0).value().tip();
}

void own_columns(int count) {
  std::vector<Segment> chain;
  chain.reserve(count);
  for (int i = 0; i < count; ++i) {
    chain.push_back(testing::columns(testing::halves(8, 3.5, 2 + 1.0 * i / count)));
  }
  predict_chain(chain, {}, cases(1, count));
}

void many_cases(int count) {
  const std::vector<Segment> chain = {testing::columns(testing::halves(8, 3.5, 2)),
                                      testing::paper_segment({36})};
  const auto response = predict_chain(chain, {}, cases(count, 2));
  for (int i = 0; i < count; ++i) shape_in(response, chain, i).value().tip();
}

std::vector<Stage> stages() {
  return {{"straight strands of two widths", doublings(8, 8192), uneven_straight},
          {"horseshoe strands of two widths", doublings(8, 8192), uneven_horseshoes},
          {"strands of a nearly even family (prepared only)", doublings(8, 32768), nearly_even},
          {"families", decades(1, 10000), families},
          {"distinct horseshoe laws", decades(1, 1000), distinct_laws},
          {"pressures", decades(1, 100000), many_pressures},
          {"segments", decades(1, 1000), many_segments},
          {"segments with columns of their own", decades(1, 1000), own_columns},
          {"load cases (tips included)", decades(1, 100000), many_cases}};
}

struct Measure {
  double size;
  double seconds;
  double memory_mb;
};

Measure measured(const Stage& stage, int size, double idle_mb) {
  const Cost cost = in_own_process(
      [&] { return fmt::format("{:.9g}", processor_seconds([&] { stage.run(size); }, 0.002)); });
  if (!cost.finished) return {static_cast<double>(size), NAN, NAN};
  return {static_cast<double>(size), std::stod(cost.result),
          std::max(0.0, cost.memory_mb - idle_mb)};
}

/// The exponent of the time over the last two decades, where the constant part no longer counts.
double exponent(const std::vector<Measure>& points) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Measure& point : points) {
    if (point.size * 101 < points.back().size || !std::isfinite(point.seconds)) continue;
    x.push_back(point.size);
    y.push_back(point.seconds);
  }
  return x.size() < 2 ? NAN : fitted_exponent(x, y);
}

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  StudyTable table("model_scaling", {"stage", "size", "seconds", "memory_mb"});
  StudyTable fits("model_scaling_fits",
                  {"what grows", "from", "to", "exponent of time", "time of the largest (ms)",
                   "per item (us)", "memory of the largest (MB)"});
  const double idle_mb = in_own_process([] { return std::string(); }).memory_mb;
  for (const Stage& stage : stages()) {
    std::vector<Measure> points;
    for (const int size : stage.sizes) {
      points.push_back(measured(stage, size, idle_mb));
      const Measure& point = points.back();
      table.add({stage.name, point.size, point.seconds, point.memory_mb});
    }
    const Measure& last = points.back();
    fits.add({stage.name, points.front().size, last.size, exponent(points), last.seconds * 1e3,
              last.seconds / last.size * 1e6, last.memory_mb});
  }
  table.write(folder, false);
  fits.write(folder);
}
