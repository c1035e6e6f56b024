// SPDX-License-Identifier: GPL-3.0-or-later
// What `build` says of a file's error against the file's real error.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/file_error.h"
#include "design/material_library.h"
#include "design/unsupported_design.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/fillet.h"
#include "geometry/solid/geometry_error.h"
#include "prepared/prepared_responses.h"
#include "report/no_equilibrium.h"
#include "report/preview.h"
#include "tests/property/exact_solid.h"
#include "tests/unit/export/test_folder.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

constexpr std::uint64_t seed = 51000;
constexpr int designs = 200;
constexpr std::size_t triangles_measured = 700;

// An error as stated and as found.
struct Pair {
  double stated = 0;
  double found = 0;
};

struct Tally {
  int count = 0;
  int below = 0;
  int far_above = 0;
  std::vector<double> ratios;

  void add(const std::string& what, const Pair& pair) {
    ++count;
    ratios.push_back(pair.stated / pair.found);
    if (pair.stated < pair.found) {
      ++below;
      std::printf("  %s: stated %.3g, found %.3g\n", what.c_str(), pair.stated, pair.found);
    }
    if (pair.stated > 1000 * pair.found) ++far_above;
  }

  void expect_true(const char* name) {
    std::sort(ratios.begin(), ratios.end());
    const auto at = [&](double part) {
      return ratios[static_cast<std::size_t>(part * (count - 1))];
    };
    std::printf("%s: %d, stated/found %.3g to %.3g, half above %.3g; %d below, %d far above\n",
                name, count, at(0), at(1), at(0.5), below, far_above);
    EXPECT_LE(below, 0.01 * count) << name;
    EXPECT_LE(far_above, 0.1 * count) << name;
  }
};

// Columns of arcs that close on the length and leave gaps.
void add_horseshoes(RandomNumbers& random, Segment& segment) {
  const double angle = random.whole(0, 1) == 0 ? 90 : random.between(35, 145);
  const bool alternate = random.whole(0, 3) > 0;
  const double arc = random.whole(0, 2) == 0 ? 180 : random.between(40, 180);
  const double along = segment.length_mm / std::sin(angle * std::numbers::pi / 180);
  const int count = random.whole(1, 6);
  const double share = 2 * std::numbers::pi * segment.lattice_mid_radius_mm() / count;
  const int arcs = static_cast<int>(std::ceil(along / share)) + random.whole(1, 5);
  const double radius = along / arcs / (2 * std::sin(0.5 * arc * std::numbers::pi / 180));
  const double width = random.log_between(0.1, 0.7) * std::min(radius, 0.4 * share);
  segment.lattice->grids.push_back(
      {angle, std::vector<double>(count, width), Horseshoe{radius, arc, alternate}});
}

void add_strips(RandomNumbers& random, Segment& segment) {
  const double around = 2 * std::numbers::pi * segment.lattice_mid_radius_mm();
  const double angle = random.whole(0, 5) == 0 ? 90 : random.between(10, 170);
  const int count = random.whole(1, 8);
  const double sine = std::sin(angle * std::numbers::pi / 180);
  const double width = random.between(0.05, 0.6) * around * sine / count;
  segment.lattice->grids.push_back({angle, std::vector<double>(count, width), StraightPath{}});
}

Design random_design(RandomNumbers& random) {
  Design design;
  Segment segment;
  const double size = random.log_between(0.5, 20);
  segment.length_mm = size * random.log_between(2, 10);
  segment.liner = {size * random.between(0.5, 2), size * random.between(0.1, 0.5), {}};
  segment.liner.material = built_in_materials().at("ecoflex-00-50");
  segment.lattice = Lattice{size * random.between(0.05, 0.6), {}, std::nullopt, {}};
  segment.lattice->material = built_in_materials().at("hei-cast-8400");
  const int rings = random.whole(0, 8);
  if (rings >= 2) {
    const double share = segment.length_mm / rings;
    segment.lattice->rings = Rings{rings, std::nullopt, random.between(0.05, 0.7) * share};
  }
  const int families = random.whole(rings >= 2 ? 0 : 1, 2);
  for (int i = 0; i < families; ++i) {
    random.whole(0, 1) == 0 ? add_strips(random, segment) : add_horseshoes(random, segment);
  }
  if (random.whole(0, 5) == 0) segment.lattice->fillet_mm = size * random.log_between(0.02, 0.4);
  design.name = "random";
  design.segments = {segment};
  design.output.tolerance_mm = size * random.log_between(3e-4, 2e-2);
  return design;
}

bool has_horseshoes(const Segment& segment) {
  const std::vector<Grid>& grids = segment.lattice->grids;
  return std::any_of(grids.begin(), grids.end(), [](const Grid& g) { return is_curved(g.path); });
}

// The area that fillets between straight strands would have: drawn far finer than the mesh is.
double fine_area_mm2(const Segment& segment, double tolerance) {
  const double flatness = tolerance / 8;  // the mesh has half of the tolerance
  const Pattern fine =
      with_fillets(draw_lattice(segment, flatness), segment.lattice->fillet_mm, flatness);
  double twice = 0;
  for (const Strand& strand : fine.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& a = strand.outline[i];
      const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
      twice += (a.u - b.u) * (a.z + b.z);
    }
  }
  return 0.5 * twice;
}

double exact_volume_mm3(const Segment& segment, double tolerance, const ExactSolid& exact) {
  if (segment.lattice->fillet_mm == 0) return exact.volume_mm3();
  return fine_area_mm2(segment, tolerance) * segment.lattice->thickness_mm;
}

// A solid as its file holds it.
struct Written {
  TriangleMesh mesh;
  Audit audit;
  SolidError error;
};

Written written(const Solid& solid) {
  const TestFolder folder;
  write_mesh(folder / "solid.stl", solid.mesh, MeshFormat::stl);
  Written result;
  result.mesh = read_mesh(folder / "solid.stl");
  result.audit = audit(weld(result.mesh));
  result.error = error_of_file(solid, result.audit);
  return result;
}

// How many meshes keep the tolerance that was asked for.
struct Kept {
  int count = 0;
  int beyond = 0;

  void add(const std::string& what, double tolerance, double distance) {
    ++count;
    if (distance <= 1.001 * tolerance) return;
    ++beyond;
    std::printf("  %s: %.3g of the tolerance\n", what.c_str(), distance / tolerance);
  }
};

class Measurement {
 public:
  void try_design(std::uint64_t number) {
    RandomNumbers random(number);
    Design design = random_design(random);
    const Segment& segment = design.segments[0];
    if (!drawing_problems(segment).empty()) return;
    const std::string what = "seed " + std::to_string(number);
    SolidOptions options;
    options.tolerance_mm = design.output.tolerance_mm;
    options.start_z_mm = random.whole(0, 1) * random.between(0, 100);
    reach_ = 20 * options.tolerance_mm;
    measure_lattice(what, segment, options);
    if (number % 4 == 0) measure_liner(what + ", liner", segment, options);
    if (number % 3 == 0) measure_preview(what, design, random);
    ++made;
  }

  int made = 0;
  Tally surface, volume, moved;
  Kept within;

 private:
  void measure_lattice(const std::string& what, const Segment& segment,
                       const SolidOptions& options) {
    const ExactSolid exact = ExactSolid::lattice(segment, options.start_z_mm);
    const Written file = written(lattice_solid(segment, options));
    const double distance = largest_distance_mm(file.mesh, exact, reach_, triangles_measured);
    surface.add(what, {file.error.surface_mm, distance});
    within.add(what, options.tolerance_mm, distance);
    if (segment.lattice->fillet_mm > 0 && has_horseshoes(segment)) return;  // not known
    const double true_volume = exact_volume_mm3(segment, options.tolerance_mm, exact);
    volume.add(what, {file.error.volume_mm3, std::abs(file.audit.volume_mm3 - true_volume)});
  }

  void measure_liner(const std::string& what, const Segment& segment, const SolidOptions& options) {
    const ExactSolid exact = ExactSolid::liner(segment, options.start_z_mm);
    const Written file = written(liner_solid(segment, options));
    const double distance = largest_distance_mm(file.mesh, exact, reach_, triangles_measured);
    surface.add(what, {file.error.surface_mm, distance});
    volume.add(what, {file.error.volume_mm3, std::abs(file.audit.volume_mm3 - exact.volume_mm3())});
  }

  void measure_preview(const std::string& what, Design& design, RandomNumbers& random) {
    const std::optional<PreviewShape> at = predicted(design, random.between(5, 60));
    if (!at) return;
    const SolidOptions options = preview_options(design, 0, 0, {*at});
    const Segment& segment = design.segments[0];
    const Map map = [&](const Point& p) { return at->shape.moved(p, 0); };
    const auto measure = [&](const Solid& rest, const ExactSolid& exact) {
      Solid solid{moved_mesh(rest.mesh, at->shape, 0), 0, 0, rest.pieces, rest.genus};
      solid.error = moved_error(rest, solid.mesh, at->shape, 0);
      const Written file = written(solid);
      const double distance =
          largest_distance_mm(file.mesh, exact, reach_, triangles_measured / 2, map, rest.mesh);
      moved.add(what + ", preview", {file.error.surface_mm, distance});
      within.add(what, options.tolerance_mm, distance);
    };
    measure(lattice_solid(segment, options), ExactSolid::lattice(segment, 0));
    measure(liner_solid(segment, options), ExactSolid::liner(segment, 0));
  }

  // At the given pressure, or at the first half of it that has an equilibrium.
  static std::optional<PreviewShape> predicted(Design& design, double pressure) {
    for (int halving = 0; halving < 6; ++halving, pressure /= 2) {
      design.make.preview = Preview{{LoadCase{{pressure}}}};
      try {
        PreparedResponses responses(design);
        return predict_preview(responses).front();
      } catch (const NoEquilibrium&) {
        continue;
      } catch (const UnsupportedDesign&) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  double reach_ = 0;
};

TEST(MeshError, IsWhatBuildSaysItIs) {
  Measurement measurement;
  std::uint64_t number = seed;
  for (; measurement.made < designs; ++number) {
    try {
      measurement.try_design(number);
    } catch (const GeometryError&) {
      // Refused designs have no file.
    }
  }
  std::printf("seeds %llu to %llu\n", static_cast<unsigned long long>(seed),
              static_cast<unsigned long long>(number - 1));
  std::printf("tolerance: %d of %d beyond it\n", measurement.within.beyond,
              measurement.within.count);
  EXPECT_LE(measurement.within.beyond, 0.02 * measurement.within.count);
  measurement.surface.expect_true("surface");
  measurement.volume.expect_true("volume");
  measurement.moved.expect_true("moved surface");
}

}  // namespace
}  // namespace latticast
