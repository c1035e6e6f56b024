// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/ply_header.h"

#include <cstddef>
#include <sstream>
#include <string>

#include "spec/file_error.h"

namespace latticast {

void check_ply_counts(const std::filesystem::path& file, std::string_view bytes) {
  const std::size_t end = bytes.find("end_header");
  if (!bytes.starts_with("ply") || end == std::string_view::npos) {
    throw FileError(file, "does not begin with a PLY header");
  }
  std::istringstream header{std::string(bytes.substr(0, end))};
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    words >> keyword >> name;
    if (keyword != "element") {
      continue;
    }
    std::size_t count = 0;
    if (!(words >> count) || count > bytes.size()) {
      throw FileError(file, "says that it holds more \"" + name + "\" elements than it has bytes");
    }
  }
}

}  // namespace latticast
