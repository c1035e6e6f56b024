// SPDX-License-Identifier: GPL-3.0-or-later
// Data goes to standard output; progress and messages go to standard error. Characters that would
// move a terminal or hide text are shown as \u001b.
#pragma once

#include <cstdio>
#include <string_view>

namespace latticast {

class Console {
 public:
  explicit Console(bool quiet = false, std::FILE* output = stdout);

  /// A result, to the output, as it is.
  void data(std::string_view text) const;

  /// A message for people, one line; not shown when quiet.
  void note(std::string_view line) const;

  /// A problem, one line starting with "error: "; always shown.
  void error(std::string_view line) const;

  /// "[ 42 %] what": redrawn in place, on a terminal only.
  void progress(int percent, std::string_view what) const;

  /// Clears the progress line.
  void end_progress() const;

 private:
  bool quiet_;
  std::FILE* output_;
  bool terminal_;
  bool colour_;
};

}  // namespace latticast
