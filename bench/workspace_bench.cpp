// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of bending predictions once the horseshoe laws exist, and of a manipulator's workspace: a
// bending segment (2:3.5, 16 columns) and a twisting one (36 degrees), each with 100 pressures.
#include <vector>

#include <benchmark/benchmark.h>

#include "model/chain.h"
#include "model/segment_response.h"
#include "model/shape/shape.h"

namespace {

using namespace latticast;

Segment segment_with(const Grid& grid) {
  Segment segment;
  segment.length_mm = 100;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  segment.liner.material.law = NeoHookean{0.08};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.material.law = Linear{19.46, 0.5};
  lattice.rings = Rings{8, std::nullopt, 2};
  lattice.grids.push_back(grid);
  segment.lattice = lattice;
  return segment;
}

Segment bending_segment(double angle_deg, int columns) {
  std::vector<double> widths(columns, 2);
  for (int j = 0; 2 * j < columns; ++j) widths[j] = 3.5;
  return segment_with({angle_deg, widths, Horseshoe{85.0 / 32, 180, true}});
}

void bending(benchmark::State& bench, const Segment& design) {
  const PreparedSegment segment = prepare_segment(design, {});
  const std::vector<double> pressure = {30};
  while (bench.KeepRunning()) benchmark::DoNotOptimize(predict(segment, pressure));
}

void distributed_columns(benchmark::State& bench) {
  bending(bench, bending_segment(90, static_cast<int>(bench.range(0))));
}
BENCHMARK(distributed_columns)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

void superimposed(benchmark::State& bench) {
  bending(bench, bending_segment(60, static_cast<int>(bench.range(0))));
}
BENCHMARK(superimposed)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

/// Widths without a mirror plane: all five unknowns.
void superimposed_irregular(benchmark::State& bench) {
  const std::vector<double> widths = {2, 3.5, 3, 2.5, 2, 3.5, 2.5, 2.5};
  bending(bench, segment_with({60, widths, Horseshoe{85.0 / 32, 180, true}}));
}
BENCHMARK(superimposed_irregular)->Unit(benchmark::kMicrosecond);

/// From designs to tips: laws and symmetry included.
void ten_thousand_points(benchmark::State& bench) {
  const std::vector<Segment> segments = {
      bending_segment(90, 16), segment_with({36, std::vector<double>(8, 2.0), StraightPath{}})};
  std::vector<LoadCase> cases;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) cases.push_back({{30.0 * i / 99, 60.0 * j / 99}});
  }
  while (bench.KeepRunning()) {
    const ChainResponse chain = predict_chain(segments, {}, cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      benchmark::DoNotOptimize(shape_in(chain, segments, i)->tip());
    }
  }
}
BENCHMARK(ten_thousand_points)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
