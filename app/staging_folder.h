// SPDX-License-Identifier: GPL-3.0-or-later
// A folder whose files appear all at once: written aside, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace latticast {

/// Where a build's files wait, inside the folder they are meant for, until all of them are written
/// and audited. Destroying it without commit() leaves the folder as it was.
class StagingFolder {
 public:
  /// Makes `folder` if it is missing. Throws FileError.
  explicit StagingFolder(const std::filesystem::path& folder);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  /// The path at which to write a file that will be called `name`; call once for every file.
  std::filesystem::path add(const std::string& name);

  /// Moves every added file into the folder, replacing what is there. Throws FileError.
  void commit();

 private:
  std::filesystem::path folder_;
  std::filesystem::path staging_;
  bool made_folder_ = false;
  std::vector<std::string> names_;
};

}  // namespace latticast
