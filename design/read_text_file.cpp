// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "design/file_error.h"
#include "design/limits.h"

namespace latticast {

std::string read_text_file(const std::filesystem::path& file) {
  // A directory opens like a file and only fails to read, with a message that misleads.
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) throw FileError(file, "is a directory");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file, errno != 0 ? std::strerror(errno) : "cannot be opened");
  std::string text;
  std::array<char, 16384> part;
  while (stream && text.size() <= limits::file_bytes) {
    const std::size_t most = std::min(part.size(), limits::file_bytes + 1 - text.size());
    stream.read(part.data(), static_cast<std::streamsize>(most));
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw FileError(file, "cannot be read");
  return text;
}

}  // namespace latticast
