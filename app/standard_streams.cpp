// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/standard_streams.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace latticast {
namespace {

// Some file systems tell only when a file is closed that its bytes found no room.
bool closes(std::FILE* stream) {
  const int copy = ::dup(::fileno(stream));
  return copy < 0 || ::close(copy) == 0;
}

std::string lost_of(std::FILE* stream, const char* name) {
  errno = 0;
  const bool arrived = std::fflush(stream) == 0 && std::ferror(stream) == 0 && closes(stream);
  if (arrived) return {};
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return std::string(name) + " did not take all that was written to it" + reason;
}

}  // namespace

void guard_standard_streams() {
  // Of the wrong direction: reading from, or writing to, what was closed stays an error.
  constexpr std::array directions = {O_WRONLY, O_RDONLY, O_RDONLY};
  for (int stream = 0; stream < 3; ++stream) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", directions[stream]);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

std::string lost_output() {
  const std::string output = lost_of(stdout, "standard output");
  return output.empty() ? lost_of(stderr, "standard error") : output;
}

}  // namespace latticast
