// SPDX-License-Identifier: GPL-3.0-or-later
// A prediction as a table for people or CSV (docs/command-line.md).
#pragma once

#include <string>

#include "model/prediction.h"

namespace latticast {

/// |(moment)|, of both components.
double moment_size_nmm(const State& state);

/// Columns for people; a row a state, states that do not exist say so.
std::string prediction_table(const Design& design, const Prediction& prediction, Held held);

/// The contract's columns, states that exist only; with a held stretch, force_N is added at the
/// end. Without times their column is empty, so that the bytes repeat.
std::string prediction_csv(const Design& design, const Prediction& prediction, Held held,
                           bool with_times);

}  // namespace latticast
