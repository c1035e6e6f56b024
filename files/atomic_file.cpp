// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/atomic_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "design/file_error.h"

namespace latticast {
namespace {

constexpr mode_t new_file_mode = 0666;  // less the user's umask
constexpr int attempts = 10000;

std::string system_reason(int error) {
  return std::generic_category().message(error);
}

/// The file that a chain of symbolic links ends at, which need not exist.
std::filesystem::path follow_links(const std::filesystem::path& target) {
  std::filesystem::path place = target;
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(place, error); ++links) {
    if (links == 40) {
      throw FileError(target, system_reason(ELOOP));
    }
    place = place.parent_path() / std::filesystem::read_symlink(place, error);
    if (error) {
      throw FileError(target, error.message());
    }
  }
  return place;
}

std::filesystem::path folder_of(const std::filesystem::path& place) {
  return place.has_parent_path() ? place.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_name(const std::filesystem::path& folder, int attempt) {
  return folder /
         (".latticast-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part");
}

std::string descriptor_link(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target, Name name)
    : target_(target), place_(follow_links(target)) {
  if (!place_.has_filename()) {
    fail("names no file");
  }
  struct stat old {};
  const bool replaces = ::stat(place_.c_str(), &old) == 0;
  if (replaces && S_ISDIR(old.st_mode)) {
    fail("is a folder");
  }
  if (replaces && !S_ISREG(old.st_mode)) {
    fail("is not a regular file");
  }
  if (replaces && ::faccessat(AT_FDCWD, place_.c_str(), W_OK, AT_EACCESS) != 0) {
    fail(system_reason(errno));
  }
  std::error_code error;
  if (!std::filesystem::is_directory(folder_of(place_), error)) {
    fail("the folder " + folder_of(place_).string() + " does not exist");
  }
  if (name == Name::on_commit) {
    open_unnamed();
  }
  if (descriptor_ < 0) {
    open_named(replaces ? old.st_mode & 0777U : new_file_mode);
  }
  if (replaces) {
    ::fchmod(descriptor_, old.st_mode & 0777U);
  }
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
}

void TemporaryFile::fail(const std::string& reason) const {
  throw FileError(target_, reason);
}

void TemporaryFile::open_unnamed() {
#ifdef O_TMPFILE
  const int descriptor =
      ::open(folder_of(place_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, new_file_mode);
  // Without /proc (a bare chroot) the file could not be given a name later on.
  if (descriptor >= 0 && ::access(descriptor_link(descriptor).c_str(), F_OK) != 0) {
    ::close(descriptor);
    return;
  }
  descriptor_ = descriptor;
#endif
}

void TemporaryFile::open_named(unsigned mode) {
  for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
    const auto name = temporary_name(folder_of(place_), attempt);
    descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
    if (descriptor_ >= 0) {
      temporary_ = name;
    } else if (errno != EEXIST) {
      fail(system_reason(errno));
    }
  }
  if (descriptor_ < 0) {
    fail("no free name for a temporary file in its folder");
  }
}

void TemporaryFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      fail(system_reason(errno));
    }
    if (written > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
}

void TemporaryFile::give_name() {
  const std::string source = descriptor_link(descriptor_);
  for (int attempt = 0; attempt < attempts && temporary_.empty(); ++attempt) {
    const auto name = temporary_name(folder_of(place_), attempt);
    if (::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      temporary_ = name;
    } else if (errno != EEXIST) {
      fail(system_reason(errno));
    }
  }
  if (temporary_.empty()) {
    fail("no free name for a temporary file in its folder");
  }
}

void TemporaryFile::commit() {
  if (temporary_.empty()) {
    give_name();
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) {
    fail(system_reason(errno));
  }
  if (::rename(temporary_.c_str(), place_.c_str()) != 0) {
    fail(system_reason(errno));
  }
  temporary_.clear();
}

void write_file_atomically(const std::filesystem::path& target, std::string_view bytes) {
  TemporaryFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace latticast
