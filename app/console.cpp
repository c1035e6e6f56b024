// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/core.h>
#include <unistd.h>

#include "design/text/printable.h"

namespace latticast {
namespace {

bool colour_wanted() {
  // https://no-color.org: set and not empty means no colour.
  const char* refused = std::getenv("NO_COLOR");
  return refused == nullptr || *refused == '\0';
}

bool may_be_unprintable(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n') || byte >= 0x7F;
}

// Names from files and from the design must not move a terminal's cursor or turn its text. JSON
// stays the same JSON.
std::string safe(std::string_view text) {
  if (std::none_of(text.begin(), text.end(), may_be_unprintable)) return std::string(text);
  return printable(text, "\n\t");
}

// What a stream does not take is found out when the program ends (app/standard_streams.h).
void put(std::string_view text, std::FILE* stream) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

}  // namespace

Console::Console(bool quiet, std::FILE* output)
    : quiet_(quiet),
      output_(output),
      terminal_(isatty(STDERR_FILENO) != 0),
      colour_(terminal_ && colour_wanted()) {}

void Console::data(std::string_view text) const {
  put(safe(text), output_);
}

void Console::note(std::string_view line) const {
  if (quiet_) return;
  end_progress();
  put(fmt::format("{}\n", safe(line)), stderr);
}

void Console::error(std::string_view line) const {
  end_progress();
  put(fmt::format("{}error:{} {}\n", colour_ ? "\033[31m" : "", colour_ ? "\033[0m" : "",
                  safe(line)),
      stderr);
}

void Console::progress(int percent, std::string_view what) const {
  if (quiet_ || !terminal_) return;
  put(fmt::format("\r\033[K[{:3d} %] {}", percent, safe(what)), stderr);
  std::fflush(stderr);
}

void Console::end_progress() const {
  if (!quiet_ && terminal_) put("\r\033[K", stderr);
}

}  // namespace latticast
