// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "design/file_error.h"
#include "design/limits.h"

namespace latticast {
namespace {

std::string read_stream(std::FILE* stream, const std::filesystem::path& name) {
  std::string text;
  std::array<char, 16384> part;
  std::size_t taken = 1;
  while (taken > 0 && text.size() <= limits::file_bytes) {
    const std::size_t most = std::min(part.size(), limits::file_bytes + 1 - text.size());
    errno = 0;
    taken = std::fread(part.data(), 1, most, stream);
    text.append(part.data(), taken);
  }
  if (std::ferror(stream) != 0) {
    throw FileError(name, errno != 0 ? std::strerror(errno) : "cannot be read");
  }
  return text;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
  // A directory opens like a file and only fails to read, with a message that misleads.
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) throw FileError(file, "is a directory");
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"),
                                                               &std::fclose);
  if (!stream) throw FileError(file, errno != 0 ? std::strerror(errno) : "cannot be opened");
  return read_stream(stream.get(), file);
}

std::string read_standard_input() {
  return read_stream(stdin, "standard input");
}

}  // namespace latticast
