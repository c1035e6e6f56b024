// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of every stage from strands to a proved file grows with what is asked for: strands,
// rings, length, segments, a finer tolerance. Exponents are against the number of triangles made.
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "bench/study.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/fillet.h"
#include "geometry/solid/region.h"
#include "geometry/solid/relief.h"
#include "geometry/solid/tube_solids.h"
#if LATTICAST_HAS_MOLDS
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#endif

namespace latticast {
namespace {

constexpr double limit_s = 30;
constexpr double least_batch_s = 0.02;
constexpr double around_mm = 2 * 3.14159265358979 * 17;
constexpr double sine_of_36 = 0.587785252292473;

struct Asked {
  int strands = 8;
  int rings = 8;
  double length_mm = 85;
  double tolerance_mm = 0.01;
  int segments = 1;
  int arcs = 0;  // of every strand; 0: straight at 36 degrees
  double fillet_mm = 0;
};

Segment segment_of(const Asked& asked) {
  Segment segment;
  segment.length_mm = asked.length_mm;
  segment.liner = {12, 4, {}};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.fillet_mm = asked.fillet_mm;
  lattice.rings = Rings{asked.rings, {}, std::min(2.0, 0.3 * asked.length_mm / asked.rings)};
  const double share = around_mm / asked.strands;
  if (asked.arcs > 0) {
    const Horseshoe half_circles{0.5 * asked.length_mm / asked.arcs, 180, true};
    const double width = std::min(1.0, 0.15 * share);
    lattice.grids.push_back({90, std::vector<double>(asked.strands, width), half_circles});
  } else {
    const double width = std::min(2.0, 0.3 * sine_of_36 * share);
    lattice.grids.push_back({36, std::vector<double>(asked.strands, width), {}});
  }
  segment.lattice = lattice;
  return segment;
}

const std::vector<std::string> stages = {
    "drawing and fillets", "union", "triangles", "wrapping", "writing", "reading", "audit"};

// A long call is made once; a short one is repeated.
double timed(const std::function<void()>& call) {
  const std::clock_t begin = std::clock();
  call();
  const double once = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return once > least_batch_s ? once : processor_seconds(call, least_batch_s);
}

// Triangles, then the seconds of each stage.
std::string stage_times(const Asked& asked) {
  const Segment segment = segment_of(asked);
  const double tolerance = asked.tolerance_mm;
  const double flatness = 0.4 * tolerance;
  Pattern pattern;
  const double draw = timed([&] {
    pattern = draw_lattice(segment, flatness);
    if (asked.fillet_mm > 0) pattern = with_fillets(pattern, asked.fillet_mm, flatness);
  });
  const int sectors = sectors_for(segment.outer_radius_mm(), tolerance);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, segment.length_mm, sectors);
  Region region;
  const double unite_s = timed([&] { region = unite(pattern, grid, {}, tolerance); });
  Relief relief;
  const double triangles_s = timed([&] { relief.plane = triangulate(region); });
  relief.radii_mm = {wall_radii(16, 18, grid.sector_angle_rad(), 1, tolerance)};
  TriangleMesh mesh;
  const double wrap_s = timed([&] { mesh = wrap(relief); });
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("latticast-scaling-{}.stl", getpid());
  const double write_s = timed([&] { write_mesh(file, mesh, MeshFormat::stl); });
  TriangleMesh read;
  const double read_s = timed([&] { read = read_mesh(file); });
  std::filesystem::remove(file);
  const double audit_s = timed([&] {
    if (!audit(weld(read)).passes()) throw std::runtime_error("a mesh fails its audit");
  });
  return fmt::format("{} {} {} {} {} {} {} {}", mesh.triangles.size(), draw, unite_s, triangles_s,
                     wrap_s, write_s, read_s, audit_s);
}

// Segments are made one after the other; their stages are taken together as wrapping.
std::string chain_times(const Asked& asked) {
  const Segment segment = segment_of(asked);
  std::size_t triangles = 0;
  const double seconds = timed([&] {
    triangles = 0;
    for (int s = 0; s < asked.segments; ++s) {
      const SolidOptions options{asked.tolerance_mm, s * asked.length_mm, 0, 1};
      triangles += lattice_solid(segment, options).mesh.triangles.size();
    }
  });
  return fmt::format("{} {}", triangles, seconds);
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  for (char* end = nullptr;; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(number);
  }
}

// One sweep: a name, what grows, and how large it gets.
struct Sweep {
  std::string grows;
  std::vector<double> sizes;
  std::function<Asked(double)> asked;
};

std::vector<Sweep> sweeps() {
  return {
      {"strands",
       {8, 32, 128, 512, 2048, 8192},
       [](double n) {
         Asked a;
         a.strands = static_cast<int>(n);
         return a;
       }},
      {"rings",
       {8, 32, 128, 512, 2048, 8192},
       [](double n) {
         Asked a;
         a.rings = static_cast<int>(n);
         a.length_mm = 850;
         return a;
       }},
      {"length",
       {85, 340, 1360, 5440, 21760, 85000},
       [](double n) {
         Asked a;
         a.length_mm = n;
         a.rings = std::max(2, static_cast<int>(n / 10));
         return a;
       }},
      {"1/tolerance",
       {1, 10, 100, 1000, 10000},
       [](double n) {
         Asked a;
         a.tolerance_mm = 1 / n;
         return a;
       }},
      {"arcs of 16 horseshoes",
       {4, 16, 64, 256},
       [](double n) {
         Asked a;
         a.strands = 16;
         a.arcs = static_cast<int>(n);
         a.length_mm = 5 * n;
         a.rings = std::max(2, static_cast<int>(n / 2));
         return a;
       }},
      {"arcs with fillets",
       {4, 16, 64},
       [](double n) {
         Asked a;
         a.strands = 16;
         a.arcs = static_cast<int>(n);
         a.length_mm = 5 * n;
         a.rings = std::max(2, static_cast<int>(n / 2));
         a.fillet_mm = 0.5;
         return a;
       }},
      {"1/tolerance with fillets",
       {10, 30, 100, 300, 1000},
       [](double n) {
         Asked a;
         a.tolerance_mm = 1 / n;
         a.fillet_mm = 0.5;
         return a;
       }},
  };
}

// Over the cases of twice the smallest's triangles and more, which what grows has a share in, and
// of a millisecond and more; a dash where there are not two.
Cell exponent(const std::vector<double>& triangles, const std::vector<double>& seconds) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (seconds[i] < 1e-3 || triangles[i] < 2 * triangles.front()) continue;
    x.push_back(triangles[i]);
    y.push_back(seconds[i]);
  }
  if (x.size() < 2) return std::string("-");
  return fitted_exponent(x, y);
}

void study_stages(const std::filesystem::path& folder) {
  std::vector<std::string> heads = {"what grows", "size", "triangles", "memory (MB)"};
  std::vector<std::string> fitted = {"what grows", "most triangles", "most memory (MB)"};
  for (const std::string& stage : stages) heads.push_back(stage + " (ms)");
  fitted.insert(fitted.end(), stages.begin(), stages.end());
  StudyTable times("geometry_times", heads);
  StudyTable exponents("geometry_exponents", fitted);
  for (const Sweep& sweep : sweeps()) {
    std::vector<double> triangles;
    std::vector<std::vector<double>> seconds(stages.size());
    double memory = 0;
    for (const double size : sweep.sizes) {
      const Cost cost = in_own_process([&] { return stage_times(sweep.asked(size)); }, limit_s);
      const std::vector<double> n = numbers_in(cost.result);
      if (!cost.finished || n.size() != stages.size() + 1) break;
      triangles.push_back(n[0]);
      memory = cost.memory_mb;
      std::vector<Cell> row = {sweep.grows, size, n[0], memory};
      for (std::size_t i = 0; i < stages.size(); ++i) {
        seconds[i].push_back(n[i + 1]);
        row.push_back(1e3 * n[i + 1]);
      }
      times.add(row);
    }
    if (triangles.empty()) continue;
    std::vector<Cell> row = {sweep.grows, triangles.back(), memory};
    for (const std::vector<double>& times_of_stage : seconds) {
      row.push_back(exponent(triangles, times_of_stage));
    }
    exponents.add(row);
  }
  times.write(folder, false);
  exponents.write(folder);
}

// Whole solids: their size in triangles and their time.
struct Whole {
  std::string name;
  std::vector<double> sizes;
  std::function<std::string(double)> run;
};

#if LATTICAST_HAS_MOLDS
std::string mold_times(const Asked& asked, bool of_liner) {
  const Segment segment = segment_of(asked);
  std::size_t triangles = 0;
  const double seconds = timed([&] {
    Mold mold;
    if (of_liner) {
      LinerMoldOptions options;
      options.fit.tolerance_mm = asked.tolerance_mm;
      mold = liner_mold(segment, options);
    } else {
      LatticeMoldOptions options;
      options.fit.tolerance_mm = asked.tolerance_mm;
      options.pieces = 4;
      mold = lattice_mold(segment, options);
    }
    triangles = 0;
    for (const MoldPiece& piece : mold.pieces) triangles += piece.solid.mesh.triangles.size();
  });
  return fmt::format("{} {}", triangles, seconds);
}
#endif

Asked of_length(double length) {
  Asked asked;
  asked.length_mm = length;
  asked.rings = static_cast<int>(length / 10);
  return asked;
}

Asked of_tolerance(double inverse) {
  Asked asked;
  asked.tolerance_mm = 1 / inverse;
  return asked;
}

std::vector<Whole> wholes() {
  std::vector<Whole> all = {{"lattice by segments", {1, 10, 100, 1000}, [](double n) {
                               Asked asked;
                               asked.segments = static_cast<int>(n);
                               return chain_times(asked);
                             }}};
#if LATTICAST_HAS_MOLDS
  for (const bool of_liner : {false, true}) {
    const std::string name = of_liner ? "liner mold" : "lattice mold";
    all.push_back({name + " by length", {85, 340, 1360, 5440}, [of_liner](double n) {
                     return mold_times(of_length(n), of_liner);
                   }});
    all.push_back({name + " by 1/tolerance", {20, 100, 1000, 10000}, [of_liner](double n) {
                     return mold_times(of_tolerance(n), of_liner);
                   }});
  }
#endif
  return all;
}

void study_wholes(const std::filesystem::path& folder) {
  StudyTable times("solid_times", {"solid", "size", "triangles", "memory (MB)", "time (ms)"});
  StudyTable exponents("solid_exponents", {"solid and what grows", "most triangles",
                                           "time for them (ms)", "memory (MB)", "exponent"});
  for (const Whole& whole : wholes()) {
    std::vector<double> triangles;
    std::vector<double> seconds;
    double memory = 0;
    for (const double size : whole.sizes) {
      const Cost cost = in_own_process([&] { return whole.run(size); }, limit_s);
      const std::vector<double> n = numbers_in(cost.result);
      if (!cost.finished || n.size() != 2) break;
      triangles.push_back(n[0]);
      seconds.push_back(n[1]);
      memory = cost.memory_mb;
      times.add({whole.name, size, n[0], memory, 1e3 * n[1]});
    }
    if (triangles.empty()) continue;
    exponents.add(
        {whole.name, triangles.back(), 1e3 * seconds.back(), memory, exponent(triangles, seconds)});
  }
  times.write(folder, false);
  exponents.write(folder);
}

}  // namespace
}  // namespace latticast

int main(int count, char** arguments) {
  const std::filesystem::path folder = latticast::study_folder(count, arguments);
  latticast::study_stages(folder);
  latticast::study_wholes(folder);
}
