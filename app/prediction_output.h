// SPDX-License-Identifier: GPL-3.0-or-later
// A prediction as a table for people, CSV or JSON (docs/command-line.md).
#pragma once

#include <string>

#include "model/prediction.h"

namespace latticast {

/// Columns for people; a row a state, states that do not exist say so.
std::string prediction_table(const Design& design, const Prediction& prediction, Held held);

/// The contract's columns, states that exist only; with a held stretch, force_N is added at the
/// end.
std::string prediction_csv(const Design& design, const Prediction& prediction, Held held);

/// Everything: states, limit points, modulus bands, messages.
std::string prediction_json(const Design& design, const Prediction& prediction, Held held);

}  // namespace latticast
