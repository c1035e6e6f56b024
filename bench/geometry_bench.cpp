// SPDX-License-Identifier: GPL-3.0-or-later
// Time of every stage from design file to audited mesh file, for the paper's lattice, also with
// horseshoe columns and fillets, and for one of about twenty times its size.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "app/build_command.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/relief.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {
namespace {

struct Size {
  int rings;
  int strips;
  double length_mm;
  int arcs = 0;  // of a strand that is a horseshoe column
  double fillet_mm = 0;
};

constexpr Size paper_size{8, 8, 85};
constexpr Size large_size{80, 20, 850};
constexpr Size horseshoes{8, 16, 85, 16};
constexpr Size filleted{8, 8, 85, 0, 0.5};
constexpr Size filleted_horseshoes{8, 16, 85, 16, 0.5};
constexpr Size large_horseshoes{80, 20, 850, 160};
constexpr Size large_filleted{80, 20, 850, 160, 0.5};

Segment twisting_segment(const Size& size) {
  Segment segment;
  segment.length_mm = size.length_mm;
  segment.liner = {12, 4, {}};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.rings = Rings{size.rings, {}, 2};
  lattice.fillet_mm = size.fillet_mm;
  if (size.arcs > 0) {
    const Horseshoe half_circles{0.5 * size.length_mm / size.arcs, 180, true};
    lattice.grids.push_back({90, std::vector<double>(size.strips, 1.0), half_circles});
  } else {
    lattice.grids.push_back({36, std::vector<double>(size.strips, 2.0), {}});
  }
  segment.lattice = lattice;
  return segment;
}

PlaneGrid plane_of(const Segment& segment, const Pattern& pattern, double tolerance) {
  return make_plane_grid(pattern.circumference_mm, segment.length_mm,
                         sectors_for(segment.outer_radius_mm(), tolerance));
}

void unite_strands(benchmark::State& state, const Size& size) {
  const Segment segment = twisting_segment(size);
  const Pattern pattern = draw_lattice(segment, 0.005);
  const PlaneGrid grid = plane_of(segment, pattern, 0.01);
  for (auto run : state) benchmark::DoNotOptimize(unite(pattern, grid, {}, 0.01));
}

void triangulate_region(benchmark::State& state, const Size& size) {
  const Segment segment = twisting_segment(size);
  const Pattern pattern = draw_lattice(segment, 0.005);
  const Region region = unite(pattern, plane_of(segment, pattern, 0.01), {}, 0.01);
  for (auto run : state) benchmark::DoNotOptimize(triangulate(region));
}

void make_solid(benchmark::State& state, const Size& size) {
  const Segment segment = twisting_segment(size);
  for (auto run : state) {
    const Solid solid = lattice_solid(segment, {});
    state.counters["triangles"] = static_cast<double>(solid.mesh.triangles.size());
  }
}

void audit_mesh(benchmark::State& state, const Size& size) {
  const TriangleMesh mesh = weld(lattice_solid(twisting_segment(size), {}).mesh);
  for (auto run : state) {
    const Audit result = audit(mesh);
    if (!result.passes()) state.SkipWithError("the mesh fails its audit");
  }
}

void design_file_to_audited_stl(benchmark::State& state, const Size& size) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "latticast-bench";
  std::filesystem::create_directories(folder);
  const std::filesystem::path design = folder / "bench.toml";
  std::ofstream(design) << "name = \"bench\"\n[[segment]]\nlength = " << size.length_mm
                        << "\nliner = { inner_radius = 12, thickness = 4, material = "
                           "\"ecoflex-00-50\" }\n[segment.lattice]\nthickness = 2\nmaterial = "
                           "\"hei-cast-8400\"\nrings = { count = "
                        << size.rings
                        << ", width = 2 }\ngrid = [ { angle = 36, count = " << size.strips
                        << ", width = 2 } ]\n[make]\nlattice = true\n";
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  const Console console(true, nowhere);
  for (auto run : state) {
    if (run_build({{design, {}, {}}, folder, {}, false, false, false}, console) !=
        ExitStatus::done) {
      state.SkipWithError("the build failed");
    }
  }
  std::fclose(nowhere);
  std::filesystem::remove_all(folder);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB_of_all_so_far"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

BENCHMARK_CAPTURE(unite_strands, 8x8, paper_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangulate_region, 8x8, paper_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 8x8, paper_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 8x8_filleted, filleted)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 8x16_horseshoes, horseshoes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 8x16_horseshoes_filleted, filleted_horseshoes)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 80x20_horseshoes, large_horseshoes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 80x20_horseshoes_filleted, large_filleted)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(audit_mesh, 8x8, paper_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(design_file_to_audited_stl, 8x8, paper_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(unite_strands, 80x20, large_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangulate_region, 80x20, large_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_solid, 80x20, large_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(audit_mesh, 80x20, large_size)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(design_file_to_audited_stl, 80x20, large_size)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticast

BENCHMARK_MAIN();
