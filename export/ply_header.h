// SPDX-License-Identifier: GPL-3.0-or-later
// A look at a PLY header before its counts are believed.
#pragma once

#include <filesystem>
#include <string_view>

namespace latticast {

/// Throws FileError naming `file` when the header has no end, or claims more elements than the file
/// has bytes (each takes one at least): a reader would ask for memory for all of them first.
void check_ply_counts(const std::filesystem::path& file, std::string_view bytes);

}  // namespace latticast
