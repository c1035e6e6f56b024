// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/staging_folder.h"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "design/file_error.h"
#include "files/publication.h"

namespace latticast {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view prefix = ".latticast-";
constexpr std::size_t random_letters = 6;  // of mkdtemp

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string system_words(int error) {
  return std::generic_category().message(error);
}

// Only one process at a time looks for left-overs, makes its staging folder or publishes. Where a
// file system has no locks, each goes on without.
class FolderLock {
 public:
  explicit FolderLock(const Path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

bool belongs_to_a_running_build(const Path& staging) {
  const int descriptor = ::open((staging / "lock").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return errno != ENOENT;  // another user's
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

// As make_staging() names and fills them, or as versions without a lock did, by a number. Anything
// else that is called so is not ours.
bool looks_like_staging(const Path& folder) {
  const std::string name = folder.filename().string();
  if (!name.starts_with(prefix)) return false;
  const std::string_view rest = std::string_view(name).substr(prefix.size());
  if (!rest.empty() && std::all_of(rest.begin(), rest.end(), is_digit)) return true;
  std::error_code ignored;
  return rest.size() == random_letters && (std::filesystem::is_empty(folder, ignored) ||
                                           std::filesystem::exists(folder / "lock", ignored));
}

std::vector<Path> staging_folders(const Path& folder) {
  std::vector<Path> found;
  std::error_code ignored;  // a folder that cannot be listed fails where it is written to
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const bool is_folder =
        entry.symlink_status(ignored).type() == std::filesystem::file_type::directory;
    if (is_folder && looks_like_staging(entry.path())) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void clear_locked(const Path& folder) {
  for (const Path& left : staging_folders(folder)) {
    if (belongs_to_a_running_build(left)) continue;
    undo_publication(left, folder);
    std::error_code ignored;
    std::filesystem::remove_all(left, ignored);
  }
}

Path make_staging(const Path& folder) {
  std::string name = (folder / (std::string(prefix) + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) throw FileError(folder, system_words(errno));
  return name;
}

int hold_lock(const Path& staging) {
  const Path file = staging / "lock";
  const int descriptor = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor < 0) throw FileError(file, system_words(errno));
  ::flock(descriptor, LOCK_EX | LOCK_NB);
  return descriptor;
}

void remove_staging(const Path& staging, int lock) {
  std::error_code ignored;
  std::filesystem::remove_all(staging, ignored);
  if (lock >= 0) ::close(lock);
}

void remove_if_empty(const std::vector<Path>& outermost_first) {
  std::for_each(outermost_first.rbegin(), outermost_first.rend(),
                [&](const Path& folder) { ::rmdir(folder.c_str()); });
}

}  // namespace

void clear_left_overs(const Path& folder) {
  if (staging_folders(folder).empty()) return;
  const FolderLock lock(folder);
  clear_locked(folder);
}

MadeFolders::MadeFolders(const Path& folder) {
  std::error_code fault;
  for (Path missing = folder; !missing.empty() && !std::filesystem::exists(missing, fault);
       missing = missing.parent_path()) {
    made_.insert(made_.begin(), missing);
  }
  std::filesystem::create_directories(folder, fault);
  if (!fault) return;
  remove_if_empty(made_);
  throw FileError(folder, fault.message());
}

MadeFolders::~MadeFolders() {
  remove_if_empty(made_);
}

StagingFolder::StagingFolder(const Path& folder) : folder_(folder), made_(folder) {
  const FolderLock lock(folder_);
  clear_locked(folder_);
  staging_ = make_staging(folder_);
  try {
    lock_ = hold_lock(staging_);
    prepare_set(staging_);
  } catch (const FileError&) {
    remove_staging(staging_, lock_);
    throw;
  }
}

StagingFolder::~StagingFolder() {
  // A journal is there only where undoing a publication failed; a later build tries again.
  std::error_code ignored;
  if (std::filesystem::exists(staging_ / "journal", ignored)) {
    ::close(lock_);
  } else {
    remove_staging(staging_, lock_);
  }
}

Path StagingFolder::add(const std::string& name) {
  names_.push_back(name);
  return place_in_set(staging_, name);
}

void StagingFolder::take_back(std::size_t kept) {
  std::error_code ignored;
  for (; names_.size() > kept; names_.pop_back()) {
    std::filesystem::remove(place_in_set(staging_, names_.back()), ignored);
  }
}

void StagingFolder::commit() {
  const FolderLock lock(folder_);
  publish(staging_, folder_, names_);
}

}  // namespace latticast
