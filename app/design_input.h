// SPDX-License-Identifier: GPL-3.0-or-later
// Design and materials read from files, with every problem reported.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "design/design.h"
#include "design/material_library.h"

namespace latticast {

/// A design as a command is given it.
struct DesignInput {
  std::filesystem::path file;         ///< "-": standard input
  std::vector<std::string> settings;  ///< values in place of the file's: design/setting/setting.h
  std::filesystem::path materials;    ///< a file with further materials; empty: none
};

/// The built-in materials, with those of `file` (unless it is empty) added or in their place. Empty
/// after reporting every problem of that file. Throws FileError.
std::optional<MaterialLibrary> load_materials(const std::filesystem::path& file,
                                              const Console& console);

/// The design; empty after reporting every problem of it, of its settings and of the materials, or
/// that the file is a mesh or in a format that is not read. Throws FileError.
std::optional<Design> load_design(const DesignInput& input, const Console& console);

}  // namespace latticast
