// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast new`: a commented design to start from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

/// The kinds of motion that `latticast new` has a design for.
std::vector<std::string> new_kinds();

/// A commented design file of that kind, ready to build. Throws std::invalid_argument for a kind
/// that is none.
std::string new_design(const std::string& kind);

/// latticast new KIND [FILE]: writes such a design to a file that does not exist yet, KIND.toml
/// where `file` is empty. Throws as new_design does, and FileError where the file exists or cannot
/// be written.
ExitStatus run_new(const std::string& kind, const std::filesystem::path& file,
                   const Console& console);

}  // namespace latticast
