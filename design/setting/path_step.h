// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a path: design/setting/setting.h has the grammar.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace latticast {

struct PathStep {
  std::string key;
  bool is_quoted = false;

  /// The number of a list's entry, when it can be one.
  std::optional<std::size_t> number() const;
};

struct ParsedPath {
  std::vector<PathStep> steps;
  std::string problem;  ///< what is wrong; the steps are then of no use
};

/// What stands before and after the first "=" outside quotes, without the spaces around; no value
/// where there is none.
struct SplitSetting {
  std::string_view path;
  std::optional<std::string_view> value;
};
SplitSetting split_setting(std::string_view setting);

ParsedPath parse_path(std::string_view path);

/// The steps as a path again: "segment.0.length".
std::string path_text(const std::vector<PathStep>& steps, std::size_t count);

}  // namespace latticast
