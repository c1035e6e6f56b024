// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/lattice_drawing.h"

#include <algorithm>
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

double LatticeDrawing::usual_flatness_mm() const {
  constexpr double coarsest_mm = 0.01;
  constexpr double share_of_finest = 0.05;
  const Lattice& lattice = *segment_.lattice;
  double finest = thinnest_strand_mm(lattice);
  if (lattice.fillet_mm > 0) finest = std::min(finest, lattice.fillet_mm);
  return std::min(coarsest_mm, share_of_finest * finest);
}

const Region& LatticeDrawing::drawn_union() {
  if (drawn_union_) return *drawn_union_;
  const double flatness = usual_flatness_mm();
  const Pattern& drawn = rounded(flatness);
  const PlaneGrid grid = make_flat_grid(drawn.circumference_mm, drawn.length_mm);
  return drawn_union_.emplace(unite(drawn, grid, {}, flatness));
}

const std::vector<PlanePoint>& LatticeDrawing::near_places() {
  if (near_places_) return *near_places_;
  const bool wanted = sliver_mm_ > 0 && has_curved_outlines(*segment_.lattice);
  return near_places_.emplace(wanted ? latticast::near_places(drawn_union(), sliver_mm_)
                                     : std::vector<PlanePoint>{});
}

const std::vector<Sliver>& LatticeDrawing::slivers() {
  if (slivers_) return *slivers_;
  if (near_places().empty()) return slivers_.emplace();
  const bool has_fillets = segment_.lattice->fillet_mm > 0;
  return slivers_.emplace(slivers_of(rounded(usual_flatness_mm()), sliver_mm_, has_fillets));
}

const Pattern& LatticeDrawing::outlines(double flatness_mm) {
  const Pattern& drawn = rounded(flatness_mm);
  if (slivers().empty()) return drawn;
  const auto found = mended_.find(flatness_mm);
  if (found != mended_.end()) return found->second;
  return mended_.emplace(flatness_mm, without_slivers(drawn, *slivers_, sliver_mm_)).first->second;
}

const Pattern& LatticeDrawing::rounded(double flatness_mm) {
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
