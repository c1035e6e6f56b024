// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/staging_folder.h"

#include <system_error>

#include <unistd.h>

#include "design/file_error.h"

namespace latticast {

StagingFolder::StagingFolder(const std::filesystem::path& folder)
    : folder_(folder), staging_(folder / (".latticast-" + std::to_string(getpid()))) {
  std::error_code fault;
  made_folder_ = std::filesystem::create_directories(folder_, fault);
  if (fault) throw FileError(folder_, fault.message());
  std::filesystem::create_directory(staging_, fault);
  if (fault) throw FileError(staging_, fault.message());
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(staging_, ignored);
  if (made_folder_) std::filesystem::remove(folder_, ignored);  // only if nothing is in it
}

std::filesystem::path StagingFolder::add(const std::string& name) {
  names_.push_back(name);
  return staging_ / name;
}

void StagingFolder::commit() {
  for (const std::string& name : names_) {
    if (std::filesystem::is_directory(folder_ / name)) {
      throw FileError(folder_ / name, "a folder of this name is in the way");
    }
  }
  for (const std::string& name : names_) {
    std::error_code fault;
    std::filesystem::rename(staging_ / name, folder_ / name, fault);
    if (fault) throw FileError(folder_ / name, fault.message());
  }
}

}  // namespace latticast
