// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/tolerance_budget.h"

#include <algorithm>
#include <cmath>

#include "design/strand_path.h"

namespace latticast {
namespace {

constexpr double curve_share = 0.5;          // chords of curves; walls that stand on them: the rest
constexpr double facet_share = 0.85;         // of facets beside them: at rims both count
constexpr double twisted_wall_share = 0.25;  // 1/16 over 1/4
constexpr double coarsest_step_share = 0.05;
constexpr double flat_curve_share = 0.95;   // chords may be off by 1.05 of what is asked for,
constexpr double flat_fillet_share = 0.88;  // those of fillets by 1.12

// A fillet leans on chords of curved strands, and adds its own.
double share_of_each(const Lattice& lattice) {
  return lattice.fillet_mm > 0 && has_curved_strands(lattice) ? 0.5 : 1;
}

}  // namespace

bool has_curved_outlines(const Lattice& lattice) {
  return lattice.fillet_mm > 0 || has_curved_strands(lattice);
}

double thinnest_strand_mm(const Lattice& lattice) {
  double thinnest = lattice.rings ? lattice.rings->width_mm : HUGE_VAL;
  for (const Grid& grid : lattice.grids) {
    for (const double width : grid.widths_mm) thinnest = std::min(thinnest, width);
  }
  return thinnest;
}

ToleranceBudget lattice_budget(const Segment& segment, double tolerance_mm, double growth,
                               bool twisted) {
  const Lattice& lattice = *segment.lattice;
  const bool curved = has_curved_outlines(lattice);
  ToleranceBudget budget = layered_budget(tolerance_mm);
  // The error grows with the radius: chords stay within their share where they are seen.
  budget.drawing_mm = share_of_each(lattice) * curve_share * tolerance_mm *
                      segment.lattice_mid_radius_mm() / (segment.outer_radius_mm() * growth);
  budget.facets_mm = (curved ? facet_share : 1) * tolerance_mm;
  budget.walls_mm = (curved ? 1 - curve_share : 1) * tolerance_mm;
  if (twisted) budget.walls_mm *= twisted_wall_share;
  return budget;
}

ToleranceBudget layered_budget(double tolerance_mm) {
  return {.total_mm = tolerance_mm,
          .drawing_mm = curve_share * tolerance_mm,
          .facets_mm = tolerance_mm,
          .walls_mm = tolerance_mm,
          .closing_mm = tolerance_mm,
          .coarsest_step_mm = coarsest_step_share * tolerance_mm};
}

ToleranceBudget flat_pattern_budget(const Lattice& lattice, double tolerance_mm) {
  const double share =
      lattice.fillet_mm > 0 ? flat_fillet_share * share_of_each(lattice) : flat_curve_share;
  return {.total_mm = tolerance_mm, .drawing_mm = share * tolerance_mm, .closing_mm = tolerance_mm};
}

}  // namespace latticast
