// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time of wrapped meshes and of molds: the tolerance that a design asks for, from
// coarse to as fine as the mesh stays within its limits, and what comes of it. Distances are
// measured against round cylinders, true arcs and true fillets, at points all over the triangles.
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "bench/study.h"
#include "geometry/solid/tube_solids.h"
#include "tests/property/exact_solid.h"
#include "tests/unit/geometry/solid/mesh_measures.h"
#if LATTICAST_HAS_MOLDS
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#endif

namespace latticast {
namespace {

constexpr double tolerances[] = {1, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001};
constexpr double limit_s = 20;
constexpr double short_s = 0.05;  // longer calls are timed once
constexpr std::size_t triangles_measured = 700;
constexpr double reach_mm = 2;

// The paper's twisting segment, or columns of half circles between the same rings.
Segment example(bool horseshoes, double fillet_mm) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.rings = Rings{8, {}, 2};
  lattice.fillet_mm = fillet_mm;
  const Horseshoe half_circles{0.5 * segment.length_mm / 16, 180, true};
  if (horseshoes) {
    lattice.grids.push_back({90, std::vector<double>(16, 1.0), half_circles});
  } else {
    lattice.grids.push_back({36, std::vector<double>(8, 2.0), {}});
  }
  segment.lattice = lattice;
  return segment;
}

struct Case {
  std::string name;
  Segment segment;
  bool is_liner = false;
};

struct Row {
  double triangles = 0;
  double distance_mm = 0;
  double estimate_mm = 0;
  double volume_share = 0;
  double volume_estimate_share = 0;
  double seconds = 0;
};

// Relative to the true volume, which is not known of fillets: their own estimate stands for it.
Row measured(const Case& tried, double tolerance_mm) {
  SolidOptions options;
  options.tolerance_mm = tolerance_mm;
  const auto make = [&] {
    return tried.is_liner ? liner_solid(tried.segment, options)
                          : lattice_solid(tried.segment, options);
  };
  const std::clock_t begin = std::clock();
  const Solid solid = make();
  const double once = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const ExactSolid exact =
      tried.is_liner ? ExactSolid::liner(tried.segment, 0) : ExactSolid::lattice(tried.segment, 0);
  const bool known = tried.is_liner || tried.segment.lattice->fillet_mm == 0;
  Row row;
  row.triangles = static_cast<double>(solid.mesh.triangles.size());
  row.distance_mm = largest_distance_mm(solid.mesh, exact, reach_mm, triangles_measured);
  row.estimate_mm = solid.error.surface_mm;
  row.volume_estimate_share = solid.error.volume_mm3 / solid.volume_mm3;
  row.volume_share = known ? std::abs(volume_mm3(solid.mesh) / exact.volume_mm3() - 1) : HUGE_VAL;
  row.seconds = once > short_s ? once : processor_seconds([&] { make(); });
  return row;
}

std::string text_of(const Row& row) {
  return fmt::format("{} {} {} {} {} {}", row.triangles, row.distance_mm, row.estimate_mm,
                     row.volume_share, row.volume_estimate_share, row.seconds);
}

// Empty after a case that was refused or took too long.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  for (char* end = nullptr;; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(number);
  }
}

const std::vector<std::string> columns = {"solid",
                                          "tolerance (mm)",
                                          "triangles",
                                          "distance (mm)",
                                          "stated distance (mm)",
                                          "relative volume error",
                                          "stated volume error",
                                          "time to mesh (ms)",
                                          "memory (MB)"};

Cell share_or_dash(double share) {
  return std::isfinite(share) ? Cell{share} : Cell{std::string("-")};
}

void study_meshes(const std::filesystem::path& folder) {
  const std::vector<Case> cases = {{"lattice", example(false, 0)},
                                   {"lattice with fillets", example(false, 0.5)},
                                   {"horseshoes", example(true, 0)},
                                   {"horseshoes with fillets", example(true, 0.5)},
                                   {"liner", example(false, 0), true}};
  StudyTable all("mesh_error", columns);
  StudyTable page("mesh_error_examples", columns);
  for (const Case& tried : cases) {
    for (const double tolerance : tolerances) {
      const Cost cost =
          in_own_process([&] { return text_of(measured(tried, tolerance)); }, limit_s);
      const std::vector<double> n = numbers_in(cost.result);
      if (!cost.finished || n.size() != 6) break;
      const std::vector<Cell> row = {tried.name, tolerance,  n[0],
                                     n[1],       n[2],       share_or_dash(n[3]),
                                     n[4],       1e3 * n[5], cost.memory_mb};
      all.add(row);
      const bool shown = tolerance == 0.1 || tolerance == 0.01 || tolerance == 0.001;
      if (shown && (tried.name == "lattice" || tried.name == "horseshoes" || tried.is_liner)) {
        page.add(row);
      }
    }
  }
  all.write(folder, false);
  page.write(folder);
}

#if LATTICAST_HAS_MOLDS
// All pieces of a mold together: the worst estimate, the sums of the others.
std::string mold_row(const Segment& segment, bool of_liner, double tolerance_mm) {
  const auto make = [&] {
    if (!of_liner) {
      LatticeMoldOptions options;
      options.fit.tolerance_mm = tolerance_mm;
      return lattice_mold(segment, options);
    }
    LinerMoldOptions options;
    options.fit.tolerance_mm = tolerance_mm;
    return liner_mold(segment, options);
  };
  const std::clock_t begin = std::clock();
  const Mold mold = make();
  const double once = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  double triangles = 0;
  double worst = 0;
  double off = 0;
  double drawn = 0;
  double stated = 0;
  for (const MoldPiece& piece : mold.pieces) {
    triangles += static_cast<double>(piece.solid.mesh.triangles.size());
    worst = std::max(worst, piece.solid.error.surface_mm);
    stated += piece.solid.error.volume_mm3;
    drawn += piece.solid.volume_mm3;
    off += std::abs(volume_mm3(piece.solid.mesh) - piece.solid.volume_mm3);
  }
  const double seconds = once > short_s ? once : processor_seconds([&] { make(); });
  return fmt::format("{} {} {} {} {}", triangles, worst, off / drawn, stated / drawn, seconds);
}

void study_molds(const std::filesystem::path& folder) {
  const std::vector<std::string> heads = {"mold",
                                          "tolerance (mm)",
                                          "triangles",
                                          "stated distance (mm)",
                                          "volume off its drawing (relative)",
                                          "stated volume error",
                                          "time (ms)",
                                          "memory (MB)"};
  StudyTable all("mold_error", heads);
  StudyTable page("mold_error_examples", heads);
  struct Tried {
    const char* name;
    Segment segment;
    bool of_liner;
  };
  for (const Tried& tried : {Tried{"lattice mold", example(false, 0), false},
                             Tried{"horseshoe mold", example(true, 0), false},
                             Tried{"liner mold", example(false, 0), true}}) {
    // Molds are never coarser than a share of their clearance.
    for (const double tolerance : {0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
      const Cost cost = in_own_process(
          [&] { return mold_row(tried.segment, tried.of_liner, tolerance); }, limit_s);
      const std::vector<double> n = numbers_in(cost.result);
      if (!cost.finished || n.size() != 5) break;
      const std::vector<Cell> row = {
          std::string(tried.name), tolerance, n[0], n[1], n[2], n[3], 1e3 * n[4], cost.memory_mb};
      all.add(row);
      if (tolerance == 0.05 || tolerance == 0.01 || tolerance == 0.002) page.add(row);
    }
  }
  all.write(folder, false);
  page.write(folder);
}
#endif

}  // namespace
}  // namespace latticast

int main(int count, char** arguments) {
  const std::filesystem::path folder = latticast::study_folder(count, arguments);
  latticast::study_meshes(folder);
#if LATTICAST_HAS_MOLDS
  latticast::study_molds(folder);
#endif
}
