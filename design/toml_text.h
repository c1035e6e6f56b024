// SPDX-License-Identifier: GPL-3.0-or-later
// TOML text as a plain tree of values that know where they stand in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "design/issue.h"

namespace latticast {

struct TomlMember;

/// A date or time; no key of a design takes one, so only its text is kept.
struct TomlDate {
  std::string text;
};

struct TomlValue {
  using List = std::vector<TomlValue>;
  using Table = std::vector<TomlMember>;  ///< sorted by key, keys unique

  int line = 0;  ///< 1-based; 0 for the file's outermost table
  int column = 0;
  std::variant<bool, std::int64_t, double, std::string, TomlDate, List, Table> content;
};

struct TomlMember {
  std::string key;
  int key_line = 0;
  int key_column = 0;
  TomlValue value;
};

/// `root` is the outermost table, empty when there are issues.
struct TomlText {
  TomlValue root;
  std::vector<Issue> issues;  ///< at most one: nothing after the first syntax error can be trusted
};

/// Parses any bytes. Refuses text above limits::file_bytes and tables, lists or dotted keys nested
/// deeper than limits::nesting before parsing, so that neither memory nor stack can run out.
TomlText parse_toml(std::string_view text);

/// The value as a reader of messages should see it: one line, control characters escaped, long text
/// and lists shortened, tables as {...}.
std::string written(const TomlValue& value);

/// A key as TOML spells it, quoted where it must be; escaped and shortened like `written`.
std::string written_key(std::string_view key);

}  // namespace latticast
