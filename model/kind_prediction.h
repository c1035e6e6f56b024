// SPDX-License-Identifier: GPL-3.0-or-later
// A design predicted with another kind of wall than its own: what the layered section, the bonded
// section that a unit cell has calibrated and the cell itself say, side by side.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "design/wall_kind.h"
#include "model/prediction.h"

namespace latticast {

inline constexpr std::array compared_kinds = {WallKind::layered, WallKind::bonded,
                                              WallKind::unit_cell};

struct KindPrediction {
  WallKind kind = WallKind::layered;
  std::optional<Prediction> prediction;
  std::string refusal;  ///< why there is none
};

/// As predict_design(), without bands. Throws std::invalid_argument when there is no load at all.
KindPrediction predict_kind(const Design& design, WallKind kind,
                            const std::vector<double>& pressures_kpa, Held held);

}  // namespace latticast
