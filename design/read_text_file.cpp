// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_text_file.h"

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
  std::string text(limits::file_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw FileError(file, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace latticast
