// SPDX-License-Identifier: GPL-3.0-or-later
// Atomic file writer: a file is written under a temporary name, then renamed, so that it appears
// whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace latticast {

/// A file being written. Until commit() the target is untouched, and afterwards it holds every byte
/// that was written; a reader never sees a part of it. Destroying an uncommitted file leaves
/// nothing.
///
/// Where the file system allows it (O_TMPFILE: ext4, xfs, btrfs, tmpfs) the bytes have no name
/// until commit(), so that even a killed process leaves nothing. Elsewhere they lie in the target's
/// folder as ".latticast-PID-N.part", removed by the destructor; a process that ends without
/// unwinding (an unhandled signal) leaves that file, never a damaged target.
///
/// The target may be a symbolic link: the file that it points to is replaced, the link stays. A
/// replaced file's permissions are kept. Every error is checked; bytes are handed to the system but
/// not forced to the disk.
///
/// Every member but the destructor throws FileError, naming the target: missing or read-only
/// folder, a target that is a folder, a device or a write-protected file, a full disk.
class TemporaryFile {
 public:
  enum class Name { on_commit, at_once };

  /// `at_once` gives the bytes a name from the start even where that is not needed.
  explicit TemporaryFile(const std::filesystem::path& target, Name name = Name::on_commit);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Appends bytes.
  void write(std::string_view bytes);

  /// Puts the file in the target's place. Call once, last; nothing may be written afterwards.
  void commit();

 private:
  void open_unnamed();
  void open_named(unsigned mode);
  void give_name();
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path target_;     // as given, for messages
  std::filesystem::path place_;      // target with its symbolic links followed
  std::filesystem::path temporary_;  // empty while the file has no name
  int descriptor_ = -1;
};

/// Writes a whole file through TemporaryFile. Throws FileError as that does.
void write_file_atomically(const std::filesystem::path& target, std::string_view bytes);

}  // namespace latticast
