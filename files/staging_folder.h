// SPDX-License-Identifier: GPL-3.0-or-later
// A folder whose files appear all at once: written aside, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace latticast {

/// Removes what builds that were killed left in `folder`, after undoing a publication that one of
/// them began (files/publication.h). What belongs to a build that is still running stays. Nothing
/// where there is no such folder. Throws FileError.
void clear_left_overs(const std::filesystem::path& folder);

/// Folders made where they were missing; those that are still empty go again.
class MadeFolders {
 public:
  /// Throws FileError.
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // outermost first
};

/// Where a build's files wait, inside the folder they are meant for, until all of them are written
/// and audited. Destroying it without commit() leaves the folder as it was. Two of them may be
/// meant for one folder: the files of the one that commits later stay.
///
/// The files lie in ".latticast-XXXXXX", which is the user's alone and holds a lock as long as its
/// process lives: that tells it from the left-over of a killed one.
class StagingFolder {
 public:
  /// Makes `folder` if it is missing, and clears left-overs. Throws FileError.
  explicit StagingFolder(const std::filesystem::path& folder);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  /// The path at which to write a file that will be called `name`; call once for every file.
  std::filesystem::path add(const std::string& name);

  std::size_t count() const { return names_.size(); }  ///< of added files

  /// Forgets all but the first `kept` files; they may be written or not.
  void take_back(std::size_t kept);

  /// Moves every added file into the folder, replacing what is there. Throws FileError, and the
  /// folder is then as it was.
  void commit();

 private:
  std::filesystem::path folder_;
  MadeFolders made_;
  std::filesystem::path staging_;
  int lock_ = -1;
  std::vector<std::string> names_;
};

}  // namespace latticast
