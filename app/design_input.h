// SPDX-License-Identifier: GPL-3.0-or-later
// Design and materials read from files, with every problem reported.
#pragma once

#include <filesystem>
#include <optional>

#include "app/console.h"
#include "design/design.h"
#include "design/material_library.h"

namespace latticast {

/// The built-in materials, with those of `file` (when given) added or in their place. Empty after
/// reporting every problem of that file. Throws FileError.
std::optional<MaterialLibrary> load_materials(const std::optional<std::filesystem::path>& file,
                                              const Console& console);

/// The design in a file; empty after reporting every problem of it, or that it is a mesh or in a
/// format that is not read. Throws FileError.
std::optional<Design> load_design(const std::filesystem::path& file,
                                  const MaterialLibrary& materials, const Console& console);

}  // namespace latticast
