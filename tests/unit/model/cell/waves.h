// SPDX-License-Identifier: GPL-3.0-or-later
// Segments with horseshoe columns and a ring each wave, for their unit cells.
#pragma once

#include <optional>
#include <vector>

#include "tests/unit/model/segments.h"

namespace latticast::testing {

inline constexpr double wave_mm = 85.0 / 8;

inline ModelChoice unit_cell() {
  ModelChoice model;
  model.wall = WallKind::unit_cell;
  return model;
}

/// Horseshoe columns of these widths, a ring each wave at this phase of it.
inline Segment waves(const std::vector<double>& widths, double phase) {
  Segment segment = columns(widths);
  segment.lattice->material.law = Linear{19.46, 0.49};
  segment.lattice->rings =
      Rings{.count = std::nullopt, .pitch_mm = wave_mm, .width_mm = 2, .phase = phase};
  return segment;
}

inline Segment elongating(double phase) {
  return waves(std::vector<double>(16, 2.0), phase);
}

}  // namespace latticast::testing
