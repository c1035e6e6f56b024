// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/prepared_segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "design/unsupported_design.h"
#include "model/cell/unit_cell.h"
#include "model/section/calibration.h"
#include "model/section/section_reading.h"
#include "model/section/section_symmetry.h"

namespace latticast {
namespace {

std::shared_ptr<const UnitCell> needed_cell(const Segment& segment, const ModelChoice& model) {
  FoundCell found = find_unit_cell(segment, model.cell_error_percent);
  if (found.cell) return found.cell;
  throw UnsupportedDesign("the unit cell " + found.reason +
                          "; kind = \"layered\" predicts this segment without one");
}

bool is_flat(const Section& section) {
  return std::abs(section.families.front().sine) < std::sin(least_calibrated_angle_rad);
}

/// Empty, or why the section stays as it is.
std::string calibrate(const UnitCell& cell, Section& section) {
  if (is_flat(section)) return "its strands are too flat for their strains to be told apart";
  const auto at_rest = UnitCellEnergy(cell).at({});
  if (!at_rest) return "the unit cell could not be solved at rest";
  const auto calibration = calibrated_at_rest(section, at_rest->energy);
  if (!calibration) return "the unit cell's meshes are too coarse for so slender a lattice";
  section.calibration = std::make_shared<const Calibration>(*calibration);
  return {};
}

/// The section that leads to a drawn cell's states, with the cell's symmetry in place of its own.
Section leading_section(const Segment& segment, ModelChoice model, const UnitCell& cell,
                        const StrandLaws& known) {
  model.wall = WallKind::layered;
  Section section = prepare_section(segment, model, known);
  adopt_symmetry(cell.twists, cell.bends, section);
  return section;
}

/// A section that the cell has calibrated tells nearly where the cell's next state is.
void follow_cell(const UnitCell& cell, Section& section) {
  const std::string fault = calibrate(cell, section);
  if (fault.empty() || is_flat(section)) return;
  throw UnsupportedDesign(fault + "; kind = \"layered\" predicts this segment without one");
}

// What docs/bonded.md#accuracy has figures for.
constexpr double least_liner_by_radius = 0.3;
constexpr double least_modulus_ratio = 20;
constexpr double most_modulus_ratio = 7000;

std::string calibration_doubt(const Segment& segment) {
  std::string what;
  if (segment.liner.thickness_mm < least_liner_by_radius * segment.inner_radius_mm()) {
    what = "a liner thinner than 0.3 times its bore's radius";
  }
  const double ratio =
      strand_modulus_mpa(*segment.lattice) / rest_shear_modulus_mpa(segment.liner.material.law);
  if (ratio < least_modulus_ratio || ratio > most_modulus_ratio) {
    what += (what.empty() ? "" : " and ") + std::string(
                                                "a lattice whose E is not 20 to 7000 times "
                                                "the liner's shear modulus");
  }
  if (what.empty()) return what;
  return "calibration at rest may not carry far for " + what +
         " (docs/bonded.md): calibrate = \"state\" says how far it is off";
}

void calibrate(FoundCell found, const Segment& segment, Calibrate what, PreparedSegment& prepared) {
  auto& section = std::get<Section>(prepared.section);
  if (found.cell && found.cell->kind == UnitCellKind::drawn) {
    adopt_symmetry(found.cell->twists, found.cell->bends, section);
  }
  prepared.not_calibrated =
      found.cell ? calibrate(*found.cell, section) : "the unit cell " + found.reason;
  if (!prepared.not_calibrated.empty()) return;
  prepared.cell = std::move(found.cell);
  prepared.calibrate = what;
  prepared.calibration_doubt = calibration_doubt(segment);
}

/// Of curved strands bonding says nothing by itself: the layered section is what the cell corrects.
void prepare_curved(const Segment& segment, ModelChoice model, const StrandLaws& known,
                    PreparedSegment& prepared) {
  const Calibrate what = model.calibrate;
  model.wall = WallKind::layered;
  prepared.section = prepare_section(segment, model, known);
  calibrate(find_unit_cell(segment, model.cell_error_percent), segment, what, prepared);
  if (prepared.not_calibrated.empty()) return;
  throw UnsupportedDesign(
      "kind = \"bonded\" knows curved strands through their unit cell alone, and " +
      prepared.not_calibrated + "; kind = \"layered\" predicts this segment without one");
}

}  // namespace

PreparedSegment prepare_segment(const Segment& segment, const ModelChoice& model,
                                const StrandLaws& known) {
  PreparedSegment prepared;
  prepared.length_mm = segment.length_mm;
  if (model.columns == ColumnModel::rods) {
    prepared.section = prepare_rods(segment, known);
    return prepared;
  }
  if (model.wall == WallKind::unit_cell) prepared.cell = needed_cell(segment, model);
  if (prepared.cell && prepared.cell->kind == UnitCellKind::drawn) {
    prepared.section = leading_section(segment, model, *prepared.cell, known);
    return prepared;
  }
  const bool calibrated = model.wall == WallKind::bonded && model.calibrate != Calibrate::nothing;
  if (calibrated && segment.lattice && has_curved_strands(*segment.lattice)) {
    prepare_curved(segment, model, known, prepared);
    return prepared;
  }
  prepared.section = prepare_section(segment, model, known);
  if (prepared.cell) follow_cell(*prepared.cell, std::get<Section>(prepared.section));
  if (calibrated) {
    calibrate(find_unit_cell(segment, model.cell_error_percent), segment, model.calibrate,
              prepared);
  }
  return prepared;
}

StrandLaws laws_of(const PreparedSegment& segment) {
  return std::visit([](const auto& section) { return laws_of(section); }, segment.section);
}

const PreparedSegment& PreparedSegments::prepare(const Segment& segment) {
  for (const auto& [known, prepared] : segments_) {
    if (known == segment) return prepared;
  }
  PreparedSegment made = prepare_segment(segment, model_, known_laws(laws_, segment));
  for (const auto& law : laws_of(made)) laws_.emplace(law->shape(), law);
  return segments_.emplace_back(segment, std::move(made)).second;
}

}  // namespace latticast
