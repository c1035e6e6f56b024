// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast build`: plan, checks, then all files of a design.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/design_input.h"
#include "app/exit_status.h"

namespace latticast {

struct BuildArguments {
  DesignInput design;
  std::filesystem::path folder = ".";
  std::vector<std::string> only;
  bool dry_run = false;
  bool force = false;  ///< build in spite of what the checks find
  bool times = false;  ///< write the time of every stage into the report's JSON
};

/// latticast build: everything that the design's [make] names, each file audited as written, after
/// the checks that these parts need; an error among them ends it unless `force` is set. Either all
/// files appear in the folder or none. Throws FileError, UnsupportedDesign, GeometryError,
/// NoEquilibrium, Interrupted, std::invalid_argument.
ExitStatus run_build(const BuildArguments& arguments, const Console& console);

}  // namespace latticast
