// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the prediction on the paper's twisting segment (alpha 36 degrees, clear-span joint).
// `solver_us` is what the states themselves report, set-up included.
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <benchmark/benchmark.h>

#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"

namespace {

using namespace latticast;

Segment twisting_segment() {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  segment.liner.material.law = NeoHookean{0.08};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.material.law = Linear{19.46, 0.5};
  lattice.rings = Rings{8, std::nullopt, 2};
  lattice.grids.push_back({36, std::vector<double>(8, 2.0), StraightPath{}});
  segment.lattice = lattice;
  return segment;
}

void predict_pressures(benchmark::State& bench, const std::vector<double>& pressures_kpa) {
  const Segment segment = twisting_segment();
  double solver_us = 0;
  double worst_error = 0;
  int iterations = 0;
  while (bench.KeepRunning()) {
    const Response response = predict(segment, {}, pressures_kpa);
    for (const auto& state : response.states) {
      solver_us += state->time_us;
      worst_error = std::max(worst_error, state->error_estimate);
      iterations += state->iterations;
    }
  }
  using benchmark::Counter;
  bench.counters["solver_us"] = Counter(solver_us, Counter::kAvgIterations);
  bench.counters["newton_iterations"] = Counter(iterations, Counter::kAvgIterations);
  bench.counters["error_estimate"] = worst_error;
}

void thirteen_pressures(benchmark::State& bench) {
  predict_pressures(bench, {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60});
}
BENCHMARK(thirteen_pressures)->Unit(benchmark::kMicrosecond);

void one_pressure(benchmark::State& bench) {
  predict_pressures(bench, {static_cast<double>(bench.range(0))});
}
BENCHMARK(one_pressure)->Arg(5)->Arg(20)->Arg(60)->Unit(benchmark::kMicrosecond);

void limit_point(benchmark::State& bench) {
  Segment tube = twisting_segment();
  tube.lattice.reset();
  while (bench.KeepRunning()) {
    benchmark::DoNotOptimize(predict(tube, {}, std::vector<double>{100}));
  }
}
BENCHMARK(limit_point)->Unit(benchmark::kMicrosecond);

/// Energy, gradient and Hessian, by quadrature points in each of the two layers.
void energy_and_derivatives(benchmark::State& bench) {
  const Section section = prepare_section(twisting_segment(), {});
  const auto points = static_cast<int>(bench.range(0));
  const Quadrature quadrature = make_quadrature(section, points, points);
  Deformation q{0.3, -0.018, 1.2};
  const std::array<int, 3> active = {0, 1, 2};
  while (bench.KeepRunning()) {
    benchmark::DoNotOptimize(q);
    benchmark::DoNotOptimize(stored_energy(section, quadrature, q, active));
  }
}
BENCHMARK(energy_and_derivatives)->Arg(5)->Arg(24)->Unit(benchmark::kNanosecond);

}  // namespace

BENCHMARK_MAIN();
