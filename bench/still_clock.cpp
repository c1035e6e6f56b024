// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded by bench/against.sh: clocks stand still and a process has always the same number.
// Durations are written as 0, random numbers seeded by the time and names made from the process
// number repeat, and so do instructions and bytes.
#include <time.h>
#include <unistd.h>

extern "C" {
int clock_gettime(clockid_t, timespec* now) noexcept {
  *now = {.tv_sec = 1000000000, .tv_nsec = 0};
  return 0;
}
time_t time(time_t* now) noexcept {
  if (now != nullptr) *now = 1000000000;
  return 1000000000;
}
pid_t getpid() noexcept {
  return 10000;
}
}
