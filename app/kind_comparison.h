// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of the model side by side: `latticast predict --kinds`.
#pragma once

#include <string>
#include <vector>

#include "app/number_rows.h"
#include "design/design.h"
#include "model/equilibrium/state.h"

namespace latticast {

/// Stretch, twist and bending of every segment by each of compared_kinds that knows the design, a
/// row a pressure at which all of them have a state.
struct KindComparison {
  NumberRows numbers;
  std::vector<std::string> notes;  ///< "unit-cell: 0.61 s", or why a kind is left out
  bool complete = true;            ///< every pressure has its row
};

/// Throws std::invalid_argument when there is no load at all.
KindComparison compare_kinds(const Design& design, const std::vector<double>& pressures_kpa,
                             Held held);

}  // namespace latticast
