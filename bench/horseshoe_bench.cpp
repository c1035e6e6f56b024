// SPDX-License-Identifier: GPL-3.0-or-later
// Time to make a horseshoe law, from the paper's strips to the corners of the scope, and to ask it.
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "model/horseshoe_law.h"

namespace latticast {
namespace {

HorseshoeShape shape_of(double arc_deg, double slenderness) {
  return {3.5, arc_deg * std::numbers::pi / 180, 3.5 * slenderness, 2, 19.46};
}

void build_law(benchmark::State& state, double arc_deg, double slenderness) {
  const HorseshoeShape shape = shape_of(arc_deg, slenderness);
  const HorseshoeLaw law(shape);
  for ([[maybe_unused]] auto run : state) benchmark::DoNotOptimize(HorseshoeLaw(shape));
  state.counters["pieces"] = static_cast<double>(law.arc_law().breaks().size() - 1);
  state.counters["force_error"] = law.accuracy().force_error;
  state.counters["slope_error"] = law.accuracy().slope_error;
}

void build_many(benchmark::State& state, int threads) {
  std::vector<HorseshoeShape> shapes;
  shapes.reserve(16);
  for (int i = 0; i < 16; ++i) shapes.push_back(shape_of(170, 0.4 + 0.05 * i));
  for ([[maybe_unused]] auto run : state) benchmark::DoNotOptimize(horseshoe_laws(shapes, threads));
}

void ask_law(benchmark::State& state, double arc_deg, double slenderness) {
  const HorseshoeLaw law(shape_of(arc_deg, slenderness));
  // Strains in no order, so that the search for the piece cannot be foreseen.
  std::vector<double> strains(4096);
  unsigned number = 1;
  for (double& strain : strains) {
    number = number * 1664525U + 1013904223U;
    const double t = number / 4294967296.0;
    strain = law.range().lowest * (1 - t) + law.range().highest * t;
  }
  std::size_t i = 0;
  for ([[maybe_unused]] auto run : state) {
    benchmark::DoNotOptimize(law.at(strains[i++ % strains.size()]));
  }
}

BENCHMARK_CAPTURE(build_law, 170_degrees_2_of_3.5, 170, 2 / 3.5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 170_degrees_4_of_3.5, 170, 4 / 3.5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 180_degrees_0.1, 180, 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 20_degrees_0.001, 20, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 300_degrees_0.001, 300, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 300_degrees_100, 300, 100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_many, 16_laws_1_thread, 1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(build_many, 16_laws_2_threads, 2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(ask_law, 170_degrees_2_of_3.5, 170, 2 / 3.5);
BENCHMARK_CAPTURE(ask_law, 300_degrees_0.001, 300, 1e-3);

}  // namespace
}  // namespace latticast

BENCHMARK_MAIN();
