// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/lattice_drawing.h"

#include <utility>

#include "geometry/solid/fillet.h"
#include "geometry/solid/tolerance_budget.h"

namespace latticast {

double LatticeDrawing::effective_flatness_mm(double flatness_mm) const {
  return has_curved_outlines(*segment_.lattice) ? flatness_mm : 0;
}

const Pattern& LatticeDrawing::strands(double flatness_mm) {
  const double key = effective_flatness_mm(flatness_mm);
  const auto found = strands_.find(key);
  if (found != strands_.end()) return found->second;
  return strands_.emplace(key, draw_lattice(segment_, flatness_mm)).first->second;
}

const Pattern& LatticeDrawing::outlines(double flatness_mm) {
  const double fillet_mm = segment_.lattice->fillet_mm;
  if (!(fillet_mm > 0)) return strands(flatness_mm);
  const auto found = filleted_.find(flatness_mm);
  if (found != filleted_.end()) return found->second;
  Pattern rounded = with_fillets(strands(flatness_mm), fillet_mm, flatness_mm);
  return filleted_.emplace(flatness_mm, std::move(rounded)).first->second;
}

const Region& LatticeDrawing::united(double flatness_mm, const PlaneGrid& grid,
                                     std::span<const std::int32_t> cuts, double closing_mm) {
  const UnionKey key{effective_flatness_mm(flatness_mm),
                     grid.sectors,
                     grid.sector_steps,
                     grid.length_steps,
                     grid.u_step_mm,
                     grid.z_step_mm,
                     {cuts.begin(), cuts.end()},
                     closing_mm};
  const auto found = unions_.find(key);
  if (found != unions_.end()) return found->second;
  Region region = unite(outlines(flatness_mm), grid, cuts, closing_mm);
  return unions_.emplace(key, std::move(region)).first->second;
}

}  // namespace latticast
