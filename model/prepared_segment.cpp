// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/prepared_segment.h"

#include <cmath>
#include <utility>

#include "design/unsupported_design.h"
#include "model/cell/unit_cell.h"
#include "model/section/calibration.h"
#include "model/section/section_reading.h"

namespace latticast {
namespace {

void take_cell(const Segment& segment, PreparedSegment& prepared) {
  FoundCell found = find_unit_cell(segment);
  if (!found.cell) {
    throw UnsupportedDesign(found.reason +
                            "; kind = \"layered\" predicts this segment without one");
  }
  prepared.cell = std::move(found.cell);
}

/// Empty, or why the section stays as it is.
std::string calibrate(const FoundCell& found, Section& section) {
  if (!found.cell) return found.reason;
  const StrandFamily& family = section.families.front();
  if (std::abs(family.sine) < std::sin(least_calibrated_angle_rad)) {
    return "its strands are too flat for their strains to be told apart";
  }
  const auto at_rest = UnitCellEnergy(*found.cell).at({});
  if (!at_rest) return "the unit cell could not be solved at rest";
  const auto calibration = calibrated_at_rest(section, *at_rest);
  if (!calibration) return "the unit cell's mesh makes the lattice's stiffness negative";
  section.calibration = std::make_shared<const Calibration>(*calibration);
  return {};
}

void calibrate(const Segment& segment, Calibrate what, PreparedSegment& prepared) {
  if (what == Calibrate::nothing) return;
  FoundCell found = find_unit_cell(segment);
  prepared.not_calibrated = calibrate(found, std::get<Section>(prepared.section));
  if (!prepared.not_calibrated.empty()) return;
  prepared.cell = std::move(found.cell);
  prepared.calibrate = what;
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
  prepared.section = prepare_section(segment, model, known);
  if (model.wall == WallKind::unit_cell) take_cell(segment, prepared);
  if (model.wall == WallKind::bonded) calibrate(segment, model.calibrate, prepared);
  return prepared;
}

StrandLaws laws_of(const PreparedSegment& segment) {
  return std::visit([](const auto& section) { return laws_of(section); }, segment.section);
}

}  // namespace latticast
