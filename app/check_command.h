// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

struct CheckArguments {
  std::vector<std::filesystem::path> files;  ///< one design file, or any number of mesh files
  std::optional<std::filesystem::path> materials;
  std::string format = "table";  ///< table or json
};

/// latticast check: what will go wrong before plastic and silicone are spent. Status check_failed
/// when there is an error, done when there are warnings and notes at most. Throws FileError.
ExitStatus run_check(const CheckArguments& arguments, const Console& console);

}  // namespace latticast
