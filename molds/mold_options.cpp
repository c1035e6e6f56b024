// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/mold_options.h"

#include "design/design.h"
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#include "molds/pour_plan.h"

namespace latticast {
namespace {

constexpr double share_of_break = 0.25;
constexpr double usual_strain = 0.5;

MoldFit fit_of(const Design& design, const Material& cast, double wall_mm) {
  return {fit_clearance_mm(design.printer), wall_mm, design.output.tolerance_mm, mold_growth(cast)};
}

}  // namespace

double demolding_strain(const Material& cast) {
  return cast.elongation_at_break ? share_of_break * *cast.elongation_at_break : usual_strain;
}

LatticeMoldOptions lattice_mold_options(const Design& design, const Segment& segment) {
  const LatticeMold& asked = *design.make.lattice_mold;
  const Material& cast = segment.lattice->material;
  return {fit_of(design, cast, asked.wall_mm), asked.pieces, demolding_strain(cast)};
}

LinerMoldOptions liner_mold_options(const Design& design, const Segment& segment) {
  const LinerMold& asked = *design.make.liner_mold;
  return {fit_of(design, segment.liner.material, asked.wall_mm), asked.ends, asked.keyed,
          asked.pieces};
}

}  // namespace latticast
