// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/prepared_segment.h"

#include "model/cell/unit_cell.h"
#include "model/section/section_reading.h"

namespace latticast {

PreparedSegment prepare_segment(const Segment& segment, const ModelChoice& model,
                                const StrandLaws& known) {
  if (model.columns == ColumnModel::rods) {
    return {segment.length_mm, prepare_rods(segment, known), nullptr};
  }
  PreparedSegment prepared{segment.length_mm, prepare_section(segment, model, known), nullptr};
  if (model.wall == WallKind::unit_cell) {
    prepared.cell = std::make_shared<const UnitCell>(make_unit_cell(segment));
  }
  return prepared;
}

StrandLaws laws_of(const PreparedSegment& segment) {
  return std::visit([](const auto& section) { return laws_of(section); }, segment.section);
}

}  // namespace latticast
