// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of whole mold sets at a chord error of 0.01 mm, from the design to meshes in memory.
#include <vector>

#include <benchmark/benchmark.h>

#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"

namespace {

using namespace latticast;

Segment segment_with(int rings, double length_mm, const Grid& grid) {
  Segment segment;
  segment.length_mm = length_mm;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.rings = Rings{rings, std::nullopt, 2};
  lattice.grids.push_back(grid);
  segment.lattice = lattice;
  return segment;
}

void report(benchmark::State& bench, const Mold& mold) {
  std::size_t triangles = 0;
  for (const MoldPiece& piece : mold.pieces) triangles += piece.solid.mesh.triangles.size();
  bench.counters["triangles"] = static_cast<double>(triangles);
  bench.counters["pieces"] = static_cast<double>(mold.pieces.size());
}

void make_lattice_mold(benchmark::State& bench, const Segment& segment) {
  Mold mold;
  while (bench.KeepRunning()) mold = lattice_mold(segment, {});
  report(bench, mold);
}

/// `rings` x `strips` at 36 degrees, 85 mm for every 8 rings.
void strips(benchmark::State& bench) {
  const auto rings = static_cast<int>(bench.range(0));
  const auto count = static_cast<int>(bench.range(1));
  const double width = count > 8 ? 1.5 : 2;
  make_lattice_mold(bench, segment_with(rings, 85.0 / 8 * rings,
                                        {36, std::vector<double>(count, width), StraightPath{}}));
}
BENCHMARK(strips)->Args({8, 8})->Args({20, 8})->Args({80, 8})->Args({80, 20})->Unit(
    benchmark::kMillisecond);

void horseshoes(benchmark::State& bench) {
  make_lattice_mold(
      bench,
      segment_with(8, 85, {90, std::vector<double>(16, 2.0), Horseshoe{85.0 / 32, 180, true}}));
}
BENCHMARK(horseshoes)->Unit(benchmark::kMillisecond);

void liner(benchmark::State& bench) {
  const Segment segment = segment_with(8, 85, {36, std::vector<double>(8, 2.0), StraightPath{}});
  Mold mold;
  while (bench.KeepRunning()) mold = liner_mold(segment, {});
  report(bench, mold);
}
BENCHMARK(liner)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
