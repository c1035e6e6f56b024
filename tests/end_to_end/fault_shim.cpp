// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into the program: one of its calls to the system goes wrong.
//   FAULT_CALLS  letters of the calls that count: r(ename), l(ink), s(ync), u(nlink), m(kdir),
//   w(rite) FAULT_AT     how many of them go well before FAULT_KIND   "full": fails for lack of
//   room, and so does every later one of its kind; "once": only
//                that one; "kill": the program ends there
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

bool is(const char* variable, const char* value) {
  const char* set = std::getenv(variable);
  return set != nullptr && std::strcmp(set, value) == 0;
}

bool goes_wrong(char call) {
  static int made = 0;
  const char* counted = std::getenv("FAULT_CALLS");
  const char* at = std::getenv("FAULT_AT");
  if (counted == nullptr || at == nullptr || std::strchr(counted, call) == nullptr) return false;
  const int before = made++;
  const int faulty = std::atoi(at);
  if (before < faulty || (before > faulty && !is("FAULT_KIND", "full"))) return false;
  if (is("FAULT_KIND", "kill")) ::raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) noexcept {
  if (goes_wrong('r')) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  if (goes_wrong('l')) return -1;
  return static_cast<int>(::syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}

int fsync(int descriptor) {
  if (goes_wrong('s')) return -1;
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

int unlink(const char* file) noexcept {
  if (goes_wrong('u')) return -1;
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, file, 0));
}

int mkdir(const char* folder, mode_t mode) noexcept {
  if (goes_wrong('m')) return -1;
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, folder, mode));
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (descriptor > 2 && goes_wrong('w')) return -1;
  return ::syscall(SYS_write, descriptor, bytes, size);
}

}  // extern "C"
