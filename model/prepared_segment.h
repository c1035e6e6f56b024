// SPDX-License-Identifier: GPL-3.0-or-later
// A segment prepared for prediction: everything of its model that does not depend on pressure.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "design/design.h"
#include "model/effective_rods/rods.h"
#include "model/law/strand_law.h"
#include "model/section/section.h"
#include "model/strand/links.h"

namespace latticast {

struct UnitCell;

/// A segment with everything that does not depend on pressure: its symmetry settled, its horseshoe
/// laws built. Immutable: any number of predictions, on any number of threads, may share it.
struct PreparedSegment {
  double length_mm = 0;
  std::variant<Section, Rods> section;
  /// Of a unit cell, whose energy takes the place of the section's, or of a bonded section that was
  /// calibrated by it; else empty.
  std::shared_ptr<const UnitCell> cell;
  Calibrate calibrate = Calibrate::nothing;  ///< what of the section the cell has set, or will
  std::string not_calibrated;                ///< why it has set nothing although it was asked to
  std::string calibration_doubt;  ///< why what it has set may not carry far; mostly empty
};

/// Prepares a segment under the chosen column model, reusing `known` laws where they fit. Throws
/// UnsupportedDesign as prepare_section and prepare_rods do.
PreparedSegment prepare_segment(const Segment& segment, const ModelChoice& model,
                                const StrandLaws& known = {});

/// The laws that a prepared segment uses.
StrandLaws laws_of(const PreparedSegment& segment);

/// Segments prepared under one choice of model: one that equals an earlier one is that one again,
/// and laws of equal shapes are built once. For one thread at a time.
class PreparedSegments {
 public:
  explicit PreparedSegments(const ModelChoice& model) : model_(model) {}

  /// Stays where it is. Throws as prepare_segment does.
  const PreparedSegment& prepare(const Segment& segment);

 private:
  ModelChoice model_;
  std::deque<std::pair<Segment, PreparedSegment>> segments_;
  LawsByShape laws_;
};

}  // namespace latticast
