// SPDX-License-Identifier: GPL-3.0-or-later
// Time to make a horseshoe law, from the paper's strips to the corners of the scope, and to ask it.
#include <cmath>
#include <ctime>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "model/horseshoe/horseshoe_law.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

HorseshoeShape shape_of(double arc_deg, double slenderness, double radius_mm = 3.5) {
  return {radius_mm, arc_deg * std::numbers::pi / 180, radius_mm * slenderness, 2, 19.46};
}

/// The law that takes longest over the whole scope: arcs of 20 to 300 degrees, w/R_h 1e-3 to 100.
void worst_law(benchmark::State& state) {
  double worst_ms = 0;  // processor time
  double worst_arc = 0;
  double worst_slenderness = 0;
  for ([[maybe_unused]] auto run : state) {
    for (int arc = 20; arc <= 300; arc += 20) {
      for (int power = -30; power <= 20; power += 5) {
        const double slenderness = std::pow(10, 0.1 * power);
        const std::clock_t begin = std::clock();
        benchmark::DoNotOptimize(make_law(shape_of(arc, slenderness)));
        const double ms = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        if (ms <= worst_ms) continue;
        worst_ms = ms;
        worst_arc = arc;
        worst_slenderness = slenderness;
      }
    }
  }
  state.counters["worst_ms"] = worst_ms;
  state.counters["arc_deg"] = worst_arc;
  state.counters["slenderness"] = worst_slenderness;
}

void build_law(benchmark::State& state, double arc_deg, double slenderness,
               double radius_mm = 3.5) {
  const HorseshoeShape shape = shape_of(arc_deg, slenderness, radius_mm);
  const StrandLaw law = make_law(shape);
  for ([[maybe_unused]] auto run : state) benchmark::DoNotOptimize(make_law(shape));
  state.counters["pieces"] = static_cast<double>(law.table().breaks().size() - 1);
  state.counters["force_error"] = law.accuracy().force_error;
  state.counters["slope_error"] = law.accuracy().slope_error;
}

void build_many(benchmark::State& state, int threads) {
  std::vector<LinkShape> shapes;
  shapes.reserve(16);
  for (int i = 0; i < 16; ++i) shapes.push_back(shape_of(170, 0.4 + 0.05 * i));
  for ([[maybe_unused]] auto run : state) benchmark::DoNotOptimize(make_laws(shapes, threads));
}

void ask_law(benchmark::State& state, double arc_deg, double slenderness) {
  const StrandLaw law = make_law(shape_of(arc_deg, slenderness));
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

BENCHMARK_CAPTURE(build_law, 180_degrees_2_of_2.656, 180, 2 / 2.656, 2.656)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 170_degrees_2_of_3.5, 170, 2 / 3.5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 170_degrees_4_of_3.5, 170, 4 / 3.5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 180_degrees_0.1, 180, 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 20_degrees_0.001, 20, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 300_degrees_0.001, 300, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_law, 300_degrees_100, 300, 100)->Unit(benchmark::kMillisecond);
BENCHMARK(worst_law)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(build_many, 16_laws_1_thread, 1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(build_many, 16_laws_2_threads, 2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(ask_law, 170_degrees_2_of_3.5, 170, 2 / 3.5);
BENCHMARK_CAPTURE(ask_law, 300_degrees_0.001, 300, 1e-3);

}  // namespace
}  // namespace latticast

BENCHMARK_MAIN();
