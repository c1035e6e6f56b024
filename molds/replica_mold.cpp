// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/replica_mold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/core.h>

#include "geometry/solid/layered_solid.h"
#include "geometry/solid/tolerance_budget.h"
#include "molds/liner_mold.h"

namespace latticast {
namespace {

enum class PatternSheet : std::uint8_t { lattice, rod, gates };

// The rod, what stands on it as high as the lattice, and the gates through the rubber.
enum class PatternLayer : std::uint8_t { rod, lattice, gates };

Layers pattern_layers(unsigned sheets) {
  if (!has(sheets, PatternSheet::rod)) return 0;
  Layers material = only(PatternLayer::rod);
  if (has(sheets, PatternSheet::gates)) material |= only(PatternLayer::gates);
  if (has(sheets, PatternSheet::lattice) || has(sheets, PatternSheet::gates)) {
    material |= only(PatternLayer::lattice);
  }
  return material;
}

// The box is the mold of a thick tube: the flexible mold itself.
Segment flexible_tube(const LatticeMoldPlan& plan) {
  Segment tube;
  tube.length_mm = plan.shell.lattice.length_mm;
  tube.liner.inner_radius_mm = plan.shell.cast.floor_mm;
  tube.liner.thickness_mm =
      plan.shell.cast.ceiling_mm - plan.shell.cast.floor_mm + replica_rubber_mm;
  return tube;
}

LinerMoldOptions box_options(const LatticeMoldPlan& plan) {
  LinerMoldOptions box;
  box.fit = plan.options.fit;
  box.fit.growth = 1;  // the plan has grown everything already
  return box;
}

struct Height {
  double low_mm = 0;
  double high_mm = 0;
};

Height height_of(const MoldPiece& piece) {
  Height height;
  for (const Point& p : piece.solid.mesh.vertices) {
    height.low_mm = std::min(height.low_mm, p[2]);
    height.high_mm = std::max(height.high_mm, p[2]);
  }
  return height;
}

Pattern raised(Pattern pattern, double by, double length) {
  for (Strand& strand : pattern.strands) strand = moved(std::move(strand), {0, by});
  pattern.length_mm = length;
  return pattern;
}

// It takes the core's place, so it is as long. Gates end short of the box by half the clearance.
Solid pattern_solid(const LatticeMoldPlan& plan, const Height& height, double box_radius) {
  const Shell& shell = plan.shell;
  const MoldFit& fit = plan.options.fit;
  const double drawn = shell.parting.drawn_radius_mm;
  const double length = height.high_mm - height.low_mm;
  const double rod = shell.cast.floor_mm;
  const double chamfer_mm = std::min(1.0, 0.25 * rod);
  const double flatness = layered_budget(fit.tolerance_mm).drawing_mm;
  Pattern gates{shell.lattice.circumference_mm, length, {}};
  for (const Bore& bore : shell.bores) {
    gates.strands.push_back(drawn_disc(drawn, bore.middle.u / drawn, bore.middle.z - height.low_mm,
                                       bore.radius_mm, flatness));
    gates.error += disc_error(bore.radius_mm, flatness);
  }
  LayeredTube tube;
  tube.drawn_radius_mm = drawn;
  tube.length_mm = length;
  tube.start_z_mm = height.low_mm;
  tube.sheets = {raised(shell.lattice, -height.low_mm, length), draw_sleeve(drawn, length),
                 std::move(gates)};
  tube.filling = pattern_layers;
  // The rod has walls at its ends alone, flat ones: levels there would be in the chamfers' way.
  tube.layers = {{0, rod, 0},
                 {rod, shell.cast.ceiling_mm},
                 {shell.cast.ceiling_mm, box_radius - 0.5 * fit.clearance_mm}};
  tube.cuts_mm = {chamfer_mm, length - chamfer_mm};
  tube.steepness = 1;
  Solid solid = layered_solid(tube, chamfer_tolerance_mm(fit.tolerance_mm, rod));
  for (const double end : {height.low_mm, height.high_mm}) {
    chamfer(solid, end, rod, chamfer_mm);
  }
  return solid;
}

void add_notes(const LatticeMoldPlan& plan, double lattice_mm3, Mold& mold) {
  mold.notes.emplace_back(
      "Two castings: first mold rubber around the pattern, as above; open the channels that the "
      "gates leave.");
  mold.notes.push_back(fmt::format(
      "Then stand the core in the base, close the flexible mold around it, put on the cap and "
      "strap the mold; the box stays off. The lattice takes {:.1f} ml of {}: press it in through "
      "the lowest of {} channels, and plug the others when rubber stands in them.",
      1e-3 * lattice_mm3, plan.segment.lattice->material.name, plan.shell.bores.size()));
}

}  // namespace

Mold replica_mold(const Segment& segment, const LatticeMoldOptions& options) {
  return replica_mold(plan_lattice_mold(segment, options));
}

MoldExtent replica_extent(const LatticeMoldPlan& plan) {
  return extent_of(flexible_tube(plan), box_options(plan));
}

Mold replica_mold(const LatticeMoldPlan& plan) {
  const Segment tube = flexible_tube(plan);
  Mold mold = liner_mold(tube, box_options(plan));
  mold.notes.clear();
  const auto core = std::find_if(mold.pieces.begin(), mold.pieces.end(),
                                 [](const MoldPiece& piece) { return piece.name == "core"; });
  core->use = "for the second casting: inside of the lattice";
  const Height height = height_of(*core);
  const MoldPiece pattern{"pattern", pattern_solid(plan, height, tube.liner_outer_radius_mm()),
                          "for the first casting: rod with the lattice and its gates"};
  const double rod = plan.shell.cast.floor_mm;
  const double pattern_mm3 = pattern.solid.volume_mm3 - core->solid.volume_mm3;
  mold.cavity_mm3 -= pattern_mm3;
  const double both = plan.shell.cast.ceiling_mm + rod;
  const double per_area = 0.5 * both * (plan.shell.cast.ceiling_mm - rod);
  add_notes(plan, plan.fill.area_mm2 * per_area / plan.shell.parting.drawn_radius_mm, mold);
  mold.pieces.insert(mold.pieces.begin(), pattern);
  return mold;
}

}  // namespace latticast
