// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace latticast {

/// The file's bytes, but not more than one beyond limits::file_bytes: enough for whoever reads them
/// to refuse the file without holding all of it. Throws FileError when the file cannot be read.
std::string read_text_file(const std::filesystem::path& file);

/// The same for standard input.
std::string read_standard_input();

}  // namespace latticast
