// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast predict`: the response to pressure, the shape of a chain, the force against a stop.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/design_input.h"
#include "app/exit_status.h"

namespace latticast {

struct PredictArguments {
  DesignInput design;
  std::optional<std::string> pressure;  ///< as typed; without it the design's load
  std::string format = "table";         ///< table, csv or json
  std::vector<std::string> hold;        ///< twist, bend, stretch; or tip alone
  std::string shape;                    ///< tip or centre-line; empty: the segments' responses
  bool kinds = false;                   ///< all kinds of the model side by side
  bool wall = false;                    ///< what a unit cell shows of the wall
  bool times = false;                   ///< the time of each solution, in CSV and JSON
  std::filesystem::path output;         ///< file for the answer; empty or "-": standard output
};

/// latticast predict: the response of every segment. Throws FileError, UnsupportedDesign,
/// std::invalid_argument.
ExitStatus run_predict(const PredictArguments& arguments, const Console& console);

}  // namespace latticast
