// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace latticast {

/// A file could not be read or written. what() is "PATH: REASON".
struct FileError : std::runtime_error {
  FileError(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason), path(file) {}

  std::filesystem::path path;
};

}  // namespace latticast
