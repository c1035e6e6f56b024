// SPDX-License-Identifier: GPL-3.0-or-later
// Zip archives (libzip), in memory.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace latticast {

struct ZipEntry {
  std::string name;
  std::string_view bytes;
};

/// A zip archive of the entries in their order, compressed, each dated 1 January 1980, so that the
/// bytes depend on the entries alone. Throws std::runtime_error when memory runs out.
std::string zip(std::span<const ZipEntry> entries);

/// The name of a part as entries are compared: in small letters, without percent codes, backslashes
/// and a leading "/" or "./".
std::string part_name(std::string_view name);

/// Reads entries of an archive that `bytes`, which must outlive it, hold.
class ZipReader {
 public:
  /// Throws FileError naming `file` when the bytes are no zip archive.
  ZipReader(std::filesystem::path file, std::string_view bytes);
  ~ZipReader();
  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;

  /// Whether there is an entry of this name, by part_name().
  bool has(const std::string& name) const;

  /// Hands on an entry's bytes piece by piece. Throws FileError
  /// when there is no such entry or its bytes or check sum are damaged, and what `take` throws.
  void read(const std::string& name, const std::function<void(std::string_view)>& take) const;

 private:
  struct Archive;

  std::filesystem::path file_;
  std::unique_ptr<Archive> archive_;
};

}  // namespace latticast
