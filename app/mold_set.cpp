// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mold_set.h"

#include <fmt/core.h>

#include "app/plan.h"
#include "design/design.h"
#include "molds/cannot_mold.h"
#include "molds/liner_mold.h"
#include "molds/mold_options.h"
#include "molds/plugs.h"
#include "molds/pour_plan.h"
#include "molds/print_size.h"
#include "prepared/prepared_design.h"

namespace latticast {
namespace {

// What the flexible mold is cast of is the workshop's choice.
PlannedMold planned_replica_mold(PreparedDesign& prepared, std::size_t s) {
  const Design& design = prepared.design;
  Mold mold = prepared.molds.lattice_mold(s);
  Material rubber;
  rubber.name = "mold rubber";
  const Casting casting{.title = fmt::format("Flexible mold for the lattice of segment {}", s + 1),
                        .mold = mold,
                        .material = rubber,
                        .process = design.printer.process,
                        .inside = "pattern"};
  std::string procedure = pour_procedure(casting);
  return {s, "lattice-mold", std::move(mold), std::move(procedure)};
}

PlannedMold planned_lattice_mold(PreparedDesign& prepared, std::size_t s) {
  const Design& design = prepared.design;
  if (design.make.lattice_mold->method == MoldMethod::replica) {
    return planned_replica_mold(prepared, s);
  }
  const Segment& segment = design.segments[s];
  Mold mold = prepared.molds.lattice_mold(s);
  const Casting casting{.title = fmt::format("Lattice of segment {}", s + 1),
                        .mold = mold,
                        .material = segment.lattice->material,
                        .process = design.printer.process,
                        .through_bores = true};
  std::string procedure = pour_procedure(casting);
  return {s, "lattice-mold", std::move(mold), std::move(procedure)};
}

PlannedMold planned_liner_mold(PreparedDesign& prepared, std::size_t s) {
  const Design& design = prepared.design;
  const Segment& segment = design.segments[s];
  const LinerMoldOptions options = liner_mold_options(design, segment);
  Mold mold = prepared.molds.liner_mold(s);
  PlugOptions plug_options;
  plug_options.tolerance_mm = design.output.tolerance_mm;
  plug_options.closed_end = options.ends == LinerEnds::closed;
  Casting casting{.title = fmt::format("Liner of segment {}", s + 1),
                  .mold = mold,
                  .material = segment.liner.material,
                  .process = design.printer.process,
                  .into_lattice = options.keyed,
                  .extras = end_plugs(segment, plug_options)};
  std::string procedure = pour_procedure(casting);
  for (MoldPiece& plug : casting.extras) mold.pieces.push_back(std::move(plug));
  return {s, "liner-mold", std::move(mold), std::move(procedure)};
}

void check_bed(const Design& design, const std::vector<PlannedMold>& molds) {
  if (!design.printer.bed_mm) return;
  std::string problems;
  for (const PlannedMold& planned : molds) {
    for (const MoldPiece& piece : planned.mold.pieces) {
      const std::string problem = bed_problem(piece, *design.printer.bed_mm);
      if (problem.empty()) continue;
      problems += fmt::format("\n  segment {}, {}, {}: {}", planned.segment + 1, planned.kind,
                              piece.name, problem);
    }
  }
  if (!problems.empty()) throw CannotMold("the mold does not fit the printer:" + problems);
}

}  // namespace

std::vector<PlannedMold> plan_molds(PreparedDesign& prepared, const Plan& plan) {
  const Design& design = prepared.design;
  std::vector<PlannedMold> molds;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    if (plan.runs(Stage::lattice_mold) && design.segments[s].lattice) {
      molds.push_back(planned_lattice_mold(prepared, s));
    }
    if (plan.runs(Stage::liner_mold)) molds.push_back(planned_liner_mold(prepared, s));
  }
  check_bed(design, molds);
  return molds;
}

const Material* poured_material(const Design& design, const PlannedMold& planned) {
  const Segment& segment = design.segments[planned.segment];
  if (planned.kind == "liner-mold") return &segment.liner.material;
  if (design.make.lattice_mold->method == MoldMethod::replica) return nullptr;
  return &segment.lattice->material;
}

}  // namespace latticast
