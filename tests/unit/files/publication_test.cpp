// SPDX-License-Identifier: GPL-3.0-or-later
// Every place at which a publication can fail or be killed, tried one by one. The functions of the
// C library by which names change are this program's own: each call may fail, or be the last.
#include "files/publication.h"

#include <cerrno>
#include <map>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "design/file_error.h"
#include "files/staging_folder.h"
#include "tests/unit/export/test_folder.h"

namespace {

// Calls counted down to the one that goes wrong; none while negative.
int calls_left = -1;
int calls_made = 0;
bool fault_kills = false;

bool goes_wrong() {
  ++calls_made;
  if (calls_left < 0 || calls_left-- > 0) return false;
  if (fault_kills) ::raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

}  // namespace

extern "C" int rename(const char* from, const char* to) noexcept {
  if (goes_wrong()) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
extern "C" int fsync(int descriptor) {
  if (goes_wrong()) return -1;
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}
extern "C" int linkat(int from_folder, const char* from, int to_folder, const char* to,
                      int flags) noexcept {
  if (goes_wrong()) return -1;
  return static_cast<int>(::syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
extern "C" int unlink(const char* file) noexcept {
  if (goes_wrong()) return -1;
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, file, 0));
}
extern "C" int mkdir(const char* folder, mode_t mode) noexcept {
  if (goes_wrong()) return -1;
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, folder, mode));
}

namespace latticast {
namespace {

using Files = std::map<std::string, std::string>;

// Everything in the folder, left-overs too.
Files files_in(const TestFolder& folder) {
  Files files;
  for (const std::string& name : folder.names()) {
    files[name] = std::filesystem::is_directory(folder / name) ? "folder" : bytes_of(folder / name);
  }
  return files;
}

const Files old_set{{"a", "old a"}, {"b", "old b"}, {"c", "old c"}, {"mine", "kept"}};
const Files new_set{{"a", "new a"}, {"b", "new b"}, {"c", "new c"},
                    {"d", "new d"}, {"e", "new e"}, {"mine", "kept"}};

void put_old_set(const TestFolder& folder) {
  for (const auto& [name, bytes] : old_set) put_bytes(folder / name, bytes);
}

void build_new_set(const TestFolder& folder) {
  StagingFolder staging(folder.path());
  for (const char* name : {"a", "d", "b", "e", "c"}) {
    put_bytes(staging.add(name), std::string("new ") + name);
  }
  staging.commit();
}

// Runs in another process, which ends at its call number `call`; whether it was killed there.
bool is_killed_at(int call, const TestFolder& folder) {
  const pid_t child = ::fork();
  if (child == 0) {
    fault_kills = true;
    calls_left = call;
    try {
      build_new_set(folder);
    } catch (const FileError&) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSIGNALED(status)) {
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  return WIFSIGNALED(status);
}

TEST(Publication, ReplacesAllAndLeavesNothingElse) {
  const TestFolder folder;
  put_old_set(folder);
  build_new_set(folder);
  EXPECT_EQ(files_in(folder), new_set);
}

TEST(Publication, ThatFailsAnywhereLeavesTheOldSetWhole) {
  int failures = 0;
  for (int call = 0; call < 40; ++call) {
    const TestFolder folder;
    put_old_set(folder);
    fault_kills = false;
    calls_left = call;
    bool threw = false;
    try {
      build_new_set(folder);
    } catch (const FileError&) {
      threw = true;
    }
    calls_left = -1;
    failures += threw ? 1 : 0;
    const Files left = files_in(folder);
    // What cannot be linked is renamed, and cleaning up never fails a build.
    EXPECT_TRUE(left == (threw ? old_set : new_set)) << "call " << call << ", threw " << threw;
  }
  EXPECT_GE(failures, 15);
}

TEST(Publication, ThatIsKilledAnywhereIsUndoneByTheNextRun) {
  int kills = 0;
  int mixed = 0;
  for (int call = 0; call < 100; ++call) {
    const TestFolder folder;
    put_old_set(folder);
    if (!is_killed_at(call, folder)) break;
    ++kills;
    Files seen = files_in(folder);
    std::erase_if(seen, [](const auto& file) { return file.second == "folder"; });
    mixed += seen != old_set && seen != new_set ? 1 : 0;
    clear_left_overs(folder.path());
    const Files left = files_in(folder);
    EXPECT_TRUE(left == old_set || left == new_set) << "killed at call " << call;
  }
  EXPECT_GE(kills, 20);
  EXPECT_GE(mixed, 3);  // there was something to undo
}

// Some files have taken their places, and others not.
void leave_mixed(const TestFolder& folder) {
  static int call = 0;
  for (;; ++call) {
    put_old_set(folder);
    ASSERT_TRUE(is_killed_at(call, folder));
    if (bytes_of(folder / "b") == "new b") return;
    clear_left_overs(folder.path());
  }
}

TEST(Publication, MayBeKilledWhileItIsUndone) {
  int kills = 0;
  for (bool killed = true; killed; ++kills) {
    const TestFolder folder;
    leave_mixed(folder);
    const pid_t child = ::fork();
    if (child == 0) {
      fault_kills = true;
      calls_left = kills;
      clear_left_overs(folder.path());
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    killed = WIFSIGNALED(status);
    clear_left_overs(folder.path());
    EXPECT_EQ(files_in(folder), old_set) << "killed at call " << kills;
  }
  EXPECT_GE(kills, 6);
}

TEST(StagingFolders, OfARunningBuildStays) {
  const TestFolder folder;
  StagingFolder running(folder.path());
  put_bytes(running.add("a"), "running");
  build_new_set(folder);
  clear_left_overs(folder.path());
  running.commit();
  EXPECT_EQ(bytes_of(folder / "a"), "running");
  EXPECT_EQ(bytes_of(folder / "b"), "new b");
}

TEST(StagingFolders, OfOthersStay) {
  const TestFolder folder;
  std::filesystem::create_directories(folder / ".latticast-1234");         // of an older version
  std::filesystem::create_directories(folder / ".latticast-aB3dEf");       // killed before its lock
  std::filesystem::create_directories(folder / ".latticast-config/mine");  // a user's
  std::filesystem::create_directories(folder / "elsewhere");
  std::filesystem::create_directory_symlink("elsewhere", folder / ".latticast-aB3dEg");
  clear_left_overs(folder.path());
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{".latticast-aB3dEg", ".latticast-config", "elsewhere"}));
  EXPECT_TRUE(std::filesystem::exists(folder / ".latticast-config/mine"));
}

TEST(StagingFolders, LeaveNoFolderThatTheyMade) {
  const TestFolder folder;
  { const StagingFolder staging(folder / "deep/er/and deeper"); }
  EXPECT_TRUE(folder.names().empty());
  put_bytes(folder / "file", "");
  EXPECT_THROW(StagingFolder(folder / "file/below"), FileError);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
}

unsigned permissions_of(const std::filesystem::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 0777U;
}

TEST(Publication, KeepsPrivateFilesPrivate) {
  const TestFolder folder;
  put_old_set(folder);
  ::chmod((folder / "a").c_str(), 0600);
  ::chmod((folder / "b").c_str(), 0664);
  const mode_t before = ::umask(0022);
  build_new_set(folder);
  ::umask(before);
  EXPECT_EQ(permissions_of(folder / "a"), 0600U);
  EXPECT_EQ(permissions_of(folder / "b"), 0664U);
  EXPECT_EQ(permissions_of(folder / "d"), 0644U);
}

TEST(Publication, ReplacesALinkAndNotWhatItPointsTo) {
  const TestFolder folder;
  const TestFolder elsewhere;
  put_bytes(elsewhere / "precious", "untouched");
  ::chmod((elsewhere / "precious").c_str(), 0600);
  std::filesystem::create_symlink(elsewhere / "precious", folder / "a");
  build_new_set(folder);
  EXPECT_EQ(bytes_of(elsewhere / "precious"), "untouched");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "a"));
  EXPECT_EQ(bytes_of(folder / "a"), "new a");
  EXPECT_EQ(permissions_of(folder / "a"), 0600U);
}

TEST(Publication, RefusesAFolderInTheWayBeforeAnythingMoves) {
  const TestFolder folder;
  put_old_set(folder);
  std::filesystem::create_directory(folder / "e");
  EXPECT_THROW(build_new_set(folder), FileError);
  Files left = files_in(folder);
  EXPECT_EQ(left.erase("e"), 1U);
  EXPECT_EQ(left, old_set);
}

}  // namespace
}  // namespace latticast
