// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/publication.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "design/file_error.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& file, int error) {
  throw FileError(file, std::generic_category().message(error));
}

bool is_there(const Path& file) {
  struct stat unused {};
  return ::lstat(file.c_str(), &unused) == 0;
}

void take_to(const Path& from, const Path& to, const Path& blamed) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail(blamed, errno);
}

// Some file systems cannot force a folder to the disk; they say so by these.
bool is_no_promise(int error) {
  return error == EINVAL || error == ENOTSUP || error == EROFS;
}

int open_to_read(const Path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  return descriptor;
}

void force_to_disk(const Path& file) {
  const int descriptor = open_to_read(file);
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error != 0 && !is_no_promise(error)) fail(file, error);
}

// The disk writes all of them at once, so that forcing one after the other waits only once.
void force_to_disk(const std::vector<Path>& files) {
#ifdef SYNC_FILE_RANGE_WRITE
  for (const Path& file : files) {
    const int descriptor = open_to_read(file);
    ::sync_file_range(descriptor, 0, 0, SYNC_FILE_RANGE_WRITE);
    ::close(descriptor);
  }
#endif
  for (const Path& file : files) force_to_disk(file);
}

Path journal_of(const Path& set) {
  return set / "journal";
}

// A journal appears whole; names end with a zero byte, which no name holds.
std::vector<std::string> journal_names(const Path& set) {
  std::ifstream stream(journal_of(set), std::ios::binary);
  std::vector<std::string> names;
  for (std::string name; std::getline(stream, name, '\0');) {
    if (Path(name).filename() == name && name != "." && name != "..") names.push_back(name);
  }
  return names;
}

void write_journal(const Path& set, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) (text += name) += '\0';
  write_file_atomically(journal_of(set), text);
}

// The new file gets the permissions of the one that it replaces.
void prepare_place(const Path& made, const Path& place) {
  struct stat old {};
  if (::stat(place.c_str(), &old) != 0) return;
  if (S_ISDIR(old.st_mode)) throw FileError(place, "a folder of this name is in the way");
  if (!S_ISREG(old.st_mode)) throw FileError(place, "is not a regular file");
  if (::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0) fail(place, errno);
  if (::chmod(made.c_str(), old.st_mode & 0777U) != 0) fail(made, errno);
}

// A second name where the file system has them, so that the first is never without a file.
void keep(const Path& place, const Path& old) {
  if (!is_there(place)) return;
  if (::linkat(AT_FDCWD, place.c_str(), AT_FDCWD, old.c_str(), 0) == 0) return;
  take_to(place, old, place);
}

void undo_one(const Path& set, const Path& folder, const std::string& name) {
  const Path made = place_in_set(set, name);
  const Path old = set / "old" / name;
  const Path place = folder / name;
  if (!is_there(made) && is_there(place)) take_to(place, made, place);
  if (is_there(old)) take_to(old, place, place);
}

void remove_journal(const Path& set) {
  if (::unlink(journal_of(set).c_str()) != 0 && errno != ENOENT) fail(journal_of(set), errno);
}

void undo_all(const Path& set, const Path& folder, const std::vector<std::string>& names) {
  std::for_each(names.rbegin(), names.rend(),
                [&](const std::string& name) { undo_one(set, folder, name); });
  try {
    force_to_disk(folder);
  } catch (const FileError&) {
    // A disk that takes nothing more: what is on it is as good as it gets.
  }
  remove_journal(set);
}

void take_places(const Path& set, const Path& folder, const std::vector<std::string>& names) {
  write_journal(set, names);
  force_to_disk(journal_of(set));
  force_to_disk(set);
  for (const std::string& name : names) {
    keep(folder / name, set / "old" / name);
    take_to(place_in_set(set, name), folder / name, folder / name);
  }
  force_to_disk(folder);
  remove_journal(set);
}

}  // namespace

void prepare_set(const Path& set) {
  for (const char* part : {"new", "old"}) {
    if (::mkdir((set / part).c_str(), 0700) != 0) fail(set / part, errno);
  }
}

Path place_in_set(const Path& set, const std::string& name) {
  return set / "new" / name;
}

void publish(const Path& set, const Path& folder, const std::vector<std::string>& names) {
  std::vector<Path> made;
  for (const std::string& name : names) {
    made.push_back(place_in_set(set, name));
    prepare_place(made.back(), folder / name);
  }
  force_to_disk(made);
  force_to_disk(set / "new");
  try {
    take_places(set, folder, names);
  } catch (const FileError& fault) {
    try {
      undo_all(set, folder, names);
    } catch (const FileError&) {
      throw FileError(fault.path, "could not be put in place, nor could what was done be undone; "
                                  "the next build into this folder tries again");
    }
    throw;
  }
}

void undo_publication(const Path& set, const Path& folder) {
  const std::vector<std::string> names = journal_names(set);
  const bool unfinished = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return is_there(place_in_set(set, name));
  });
  if (unfinished) undo_all(set, folder, names);
}

}  // namespace latticast
