// SPDX-License-Identifier: GPL-3.0-or-later
// The materials that a design may call by name: a data file compiled in, which a user's own file
// may extend or override.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "design/issue.h"
#include "design/material/material.h"

namespace latticast {

using MaterialLibrary = std::map<std::string, Material, std::less<>>;

/// The library compiled into the program (design/materials.toml).
const MaterialLibrary& built_in_materials();

/// Reads further materials from TOML text of the same form (docs/materials.md) into `library`; an
/// entry of the same name replaces the one that is there. Returns every problem found, in file
/// order; on any problem `library` is unchanged.
std::vector<Issue> add_materials(std::string_view toml_text, MaterialLibrary& library);

/// As above from a file. Throws FileError when the file cannot be read.
std::vector<Issue> add_materials_file(const std::filesystem::path& file, MaterialLibrary& library);

}  // namespace latticast
