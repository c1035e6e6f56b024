// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast materials`: the material library as a list, or one entry.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

/// latticast materials [NAME]: the library as a list, or one entry whole. Throws FileError.
ExitStatus run_materials(const std::string& name, const std::filesystem::path& materials_file,
                         const Console& console);

}  // namespace latticast
