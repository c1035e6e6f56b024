// SPDX-License-Identifier: GPL-3.0-or-later
// One thing wrong with a design, said so that its author can mend it.
#pragma once

#include <string>
#include <string_view>

namespace latticast {

struct Issue {
  static constexpr int set_by_path = -1;

  int line = 0;       ///< 1-based; 0 when the file as a whole is meant; set_by_path where a value
                      ///< does not stand in the file (design/setting/setting.h)
  std::string key;    ///< key path, as in "segment[1].lattice.grid[0].angle" (0-based indices)
  std::string value;  ///< what was written, as text; empty when a key is missing
  std::string rule;   ///< the rule that it breaks, in plain words
  std::string hint;   ///< what to write instead
};

/// "FILE:LINE: KEY = VALUE: RULE. HINT", one line; parts that the issue does not have are left out,
/// and "FILE as set: …" is said of a value that was set.
std::string describe(const Issue& issue, std::string_view file);

}  // namespace latticast
