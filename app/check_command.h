// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast check`: the checks of a design and of mesh files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

struct CheckArguments {
  std::vector<std::filesystem::path> files;  ///< mesh files, and at most one design
  std::vector<std::string> settings = {};    ///< of the design
  std::filesystem::path materials = {};
  std::string format = {};  ///< json, otherwise a table
};

/// latticast check: what will go wrong before plastic and silicone are spent. Files with the
/// suffix of a mesh format are meshes, any other a design. Status check_failed when there is
/// an error, done when there are warnings and notes at most, file_error when a mesh cannot be read;
/// the other files are checked all the same. Throws FileError for the design and its materials.
ExitStatus run_check(const CheckArguments& arguments, const Console& console);

}  // namespace latticast
