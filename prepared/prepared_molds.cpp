// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_molds.h"

#include "design/design.h"
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#include "molds/mold_options.h"
#include "molds/replica_mold.h"
#include "prepared/prepared_lattices.h"

namespace latticast {
namespace {

// What `make` gives for the segment, made only when it is not there yet.
template <class Made, class Maker>
const Made& kept(std::map<std::size_t, std::unique_ptr<Made>>& all, std::size_t segment,
                 const Maker& make) {
  std::unique_ptr<Made>& made = all[segment];
  if (!made) made = std::make_unique<Made>(make());
  return *made;
}

}  // namespace

PreparedMolds::PreparedMolds(const Design& design, PreparedLattices& lattices)
    : design_(design), lattices_(lattices) {}
PreparedMolds::~PreparedMolds() = default;

const LatticeMoldPlan& PreparedMolds::lattice_mold_plan(std::size_t segment) {
  return kept(plans_, segment, [&] {
    return plan_lattice_mold(lattices_.of(segment),
                             lattice_mold_options(design_, design_.segments[segment]));
  });
}

const Mold& PreparedMolds::lattice_mold(std::size_t segment) {
  return kept(lattice_molds_, segment, [&] {
    const LatticeMoldPlan& plan = lattice_mold_plan(segment);
    const bool replica = design_.make.lattice_mold->method == MoldMethod::replica;
    return replica ? replica_mold(plan) : latticast::lattice_mold(plan);
  });
}

const Mold& PreparedMolds::liner_mold(std::size_t segment) {
  return kept(liner_molds_, segment, [&] {
    const Segment& of = design_.segments[segment];
    LatticeDrawing* drawing = of.lattice ? &lattices_.of(segment) : nullptr;
    return latticast::liner_mold(of, liner_mold_options(design_, of), drawing);
  });
}

}  // namespace latticast
