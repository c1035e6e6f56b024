// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of `latticast predict` for programs: docs/prediction.schema.json says what they hold.
#pragma once

#include <string>
#include <string_view>

#include "app/number_rows.h"
#include "model/prediction.h"

namespace latticast {

/// The response of every segment: states with their bands, reasons where there is none, limit
/// points. The time of each solution only when asked for, so that the bytes repeat.
std::string response_json(const Design& design, const Prediction& prediction, Held held,
                          bool with_times);

/// Rows of numbers as objects, and what has no row. `answer` names what was asked for.
std::string rows_json(const Design& design, std::string_view answer, const NumberRows& numbers);

/// Why a response has no state at one of its pressures.
std::string reason_of(const Response& response, double pressure_kpa);

}  // namespace latticast
