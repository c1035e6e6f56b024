// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/strip_tube.h"

#include <algorithm>

#include "geometry/pattern/rings.h"
#include "model/cell/cell_materials.h"

namespace latticast {
namespace {

struct NoCell {
  std::string reason;
};

[[noreturn]] void refuse(const std::string& reason) {
  throw NoCell{reason};
}

const Grid& only_family(const Lattice& lattice) {
  const Grid* only = nullptr;
  for (const Grid& grid : lattice.grids) {
    if (grid.count() == 0) continue;
    if (only != nullptr) refuse("knows lattices of one family of strands, this one has more");
    only = &grid;
  }
  if (only == nullptr) refuse("knows lattices with strands, this one has none");
  if (only->count() == 1) refuse("knows strips in twos or more, a single one bends the tube");
  if (is_curved(only->path)) refuse("knows straight strands, these are curved");
  const auto [thin, wide] = std::minmax_element(only->widths_mm.begin(), only->widths_mm.end());
  if (*thin != *wide) refuse("knows strands of equal width, these differ");
  return *only;
}

StripTube strip_tube(const Segment& segment) {
  const std::string problem = parts_problem(segment);
  if (!problem.empty()) refuse(problem);
  const Lattice& lattice = *segment.lattice;
  const Grid& grid = only_family(lattice);
  StripTube tube{.inner_radius_mm = segment.inner_radius_mm(),
                 .liner_outer_radius_mm = segment.liner_outer_radius_mm(),
                 .outer_radius_mm = segment.outer_radius_mm(),
                 .angle_rad = grid.angle_rad(),
                 .strips = grid.count(),
                 .strip_width_mm = grid.widths_mm.front(),
                 .pitch_mm = segment.lattice_circumference_mm() / grid.count(),
                 .ring_width_mm = 0,
                 .liner = segment.liner.material.law,
                 .lattice = std::get<Linear>(lattice.material.law)};
  if (lattice.rings && !ring_centres_mm(*lattice.rings, segment.length_mm).empty()) {
    tube.pitch_mm = ring_pitch_mm(*lattice.rings, segment.length_mm);
    tube.ring_width_mm = lattice.rings->width_mm;
  }
  if (lattice.fillet_mm > 0 && tube.ring_width_mm > 0) {
    refuse("knows sharp corners, these are round");
  }
  if (!(tube.ring_width_mm < tube.pitch_mm)) refuse("needs a gap between rings, these touch");
  const double around = segment.lattice_circumference_mm() * grid.direction().sine / grid.count();
  if (!(tube.strip_width_mm < around)) refuse("needs a gap between strips, these touch");
  return tube;
}

}  // namespace

FoundStrips find_strips(const Segment& segment) {
  try {
    return {strip_tube(segment), {}};
  } catch (const NoCell& none) {
    return {std::nullopt, none.reason};
  }
}

}  // namespace latticast
