// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "design/file_error.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

using Names = std::vector<std::string>;

/// Writing without the superuser's rights, whoever runs the tests.
class AsOrdinaryUser {
 public:
  AsOrdinaryUser() : before_(::geteuid()) {
    if (before_ == 0) {
      EXPECT_EQ(::seteuid(65534), 0);
    }
  }
  ~AsOrdinaryUser() { EXPECT_EQ(::seteuid(before_), 0); }

 private:
  uid_t before_;
};

/// Files may not grow past `bytes`; an attempt is an error instead of a signal.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit before_{};
  sighandler_t old_handler_;
};

bool folder_takes_unnamed_files(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  return descriptor >= 0;
}

std::string reason_of_failure(const std::filesystem::path& target) {
  try {
    write_file_atomically(target, "new");
  } catch (const FileError& error) {
    EXPECT_EQ(error.path, target);
    return error.what();
  }
  return "no failure";
}

class AtomicFile : public testing::TestWithParam<TemporaryFile::Name> {
 protected:
  void write(const std::filesystem::path& target, std::string_view bytes) {
    TemporaryFile file(target, GetParam());
    file.write(bytes);
    file.commit();
  }

  TestFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(BothWays, AtomicFile,
                         testing::Values(TemporaryFile::Name::on_commit,
                                         TemporaryFile::Name::at_once));

TEST_P(AtomicFile, HoldsEveryByteAndLeavesNothingElse) {
  std::string bytes(3'000'001, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<char>(i * 31 % 251);
  }
  TemporaryFile file(folder_ / "a", GetParam());
  file.write(std::string_view(bytes).substr(0, 17));
  file.write(std::string_view(bytes).substr(17));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a"));
  file.commit();
  EXPECT_EQ(bytes_of(folder_ / "a"), bytes);
  EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_P(AtomicFile, ReplacesAnOldFileWholeAndKeepsItsPermissions) {
  put_bytes(folder_ / "a", "a longer old text");
  ::chmod((folder_ / "a").c_str(), 0640);
  write(folder_ / "a", "new");
  EXPECT_EQ(bytes_of(folder_ / "a"), "new");
  struct stat now {};
  ASSERT_EQ(::stat((folder_ / "a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 0777U, 0640U);
}

TEST_P(AtomicFile, ANewFileHasTheUsersPermissions) {
  const mode_t before = ::umask(0027);
  write(folder_ / "a", "new");
  ::umask(before);
  struct stat now {};
  ASSERT_EQ(::stat((folder_ / "a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 0777U, 0640U);
}

TEST_P(AtomicFile, AnUncommittedFileLeavesTheOldOne) {
  put_bytes(folder_ / "a", "old");
  {
    TemporaryFile file(folder_ / "a", GetParam());
    file.write("new");
  }
  EXPECT_EQ(bytes_of(folder_ / "a"), "old");
  EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_P(AtomicFile, AFullDiskLeavesTheOldOne) {
  put_bytes(folder_ / "a", "old");
  {
    const FileSizeLimit limit(5000);
    EXPECT_THROW(write(folder_ / "a", std::string(100000, 'x')), FileError);
  }
  EXPECT_EQ(bytes_of(folder_ / "a"), "old");
  EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_P(AtomicFile, AFailedRenameLeavesNothing) {
  TemporaryFile file(folder_ / "a", GetParam());
  file.write("new");
  std::filesystem::create_directories(folder_ / "a" / "b");
  EXPECT_THROW(file.commit(), FileError);
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "a" / "b"));
}

TEST_P(AtomicFile, TwoWritersOfOneTargetDoNotMix) {
  TemporaryFile first(folder_ / "a", GetParam());
  TemporaryFile second(folder_ / "a", GetParam());
  first.write("first");
  second.write("second");
  second.commit();
  EXPECT_EQ(bytes_of(folder_ / "a"), "second");
  first.commit();
  EXPECT_EQ(bytes_of(folder_ / "a"), "first");
  EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_P(AtomicFile, WritesThroughSymbolicLinks) {
  std::filesystem::create_directory(folder_ / "real");
  put_bytes(folder_ / "real/file", "old");
  std::filesystem::create_symlink("real/file", folder_ / "middle");
  std::filesystem::create_symlink("middle", folder_ / "link");
  write(folder_ / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  EXPECT_EQ(bytes_of(folder_ / "real/file"), "new");
}

TEST_P(AtomicFile, ALinkToNothingMakesTheFileThatItNames) {
  std::filesystem::create_symlink("later", folder_ / "link");
  write(folder_ / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  EXPECT_EQ(bytes_of(folder_ / "later"), "new");
}

TEST(AtomicFileKilled, LeavesTheOldFileAndNothingElse) {
  const TestFolder folder;
  if (!folder_takes_unnamed_files(folder.path())) {
    GTEST_SKIP() << "this file system has no unnamed files";
  }
  put_bytes(folder / "a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    TemporaryFile file(folder / "a");
    file.write("new");
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(bytes_of(folder / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(AtomicFileRefuses, AMissingFolder) {
  const TestFolder folder;
  EXPECT_NE(reason_of_failure(folder / "no/such/a").find("does not exist"), std::string::npos);
}

TEST(AtomicFileRefuses, AFolderAsTarget) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "a");
  EXPECT_NE(reason_of_failure(folder / "a").find("is a folder"), std::string::npos);
  EXPECT_NE(reason_of_failure(folder.path().string() + "/").find("names no file"),
            std::string::npos);
}

TEST(AtomicFileRefuses, ADevice) {
  EXPECT_NE(reason_of_failure("/dev/full").find("not a regular file"), std::string::npos);
}

TEST(AtomicFileRefuses, ALoopOfLinks) {
  const TestFolder folder;
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  EXPECT_NE(reason_of_failure(folder / "a").find("symbolic links"), std::string::npos);
}

TEST(AtomicFileRefuses, AReadOnlyFolder) {
  const TestFolder folder;
  put_bytes(folder / "a", "old");
  ::chmod((folder / "a").c_str(), 0666);
  ::chmod(folder.path().c_str(), 0555);
  {
    const AsOrdinaryUser user;
    EXPECT_NE(reason_of_failure(folder / "a").find("Permission denied"), std::string::npos);
    EXPECT_NE(reason_of_failure(folder / "b").find("Permission denied"), std::string::npos);
  }
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(bytes_of(folder / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(AtomicFileRefuses, AWriteProtectedFile) {
  const TestFolder folder;
  put_bytes(folder / "a", "old");
  ::chmod((folder / "a").c_str(), 0444);
  ::chmod(folder.path().c_str(), 0777);
  {
    const AsOrdinaryUser user;
    EXPECT_NE(reason_of_failure(folder / "a").find("Permission denied"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(folder / "a"), "old");
}

}  // namespace
}  // namespace latticast
