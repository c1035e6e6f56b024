// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/toml_text.h"

#include <algorithm>
#include <sstream>

#include <fmt/core.h>
#include <toml++/toml.h>

#include "design/limits.h"
#include "design/text/printable.h"
#include "design/text/written_number.h"

namespace latticast {
namespace {

/// Walks over text without understanding more of it than strings and comments, which is what it
/// takes to tell brackets and key dots from mere characters.
class NestingScan {
 public:
  explicit NestingScan(std::string_view text) : text_(text) {}

  /// The line at which nesting passes the limit; 0 when it never does.
  int line_too_deep() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
      } else if (c == '#') {
        skip_comment();
      } else {
        count(c);
        ++at_;
      }
      if (open_ > limits::nesting || dots_ > limits::nesting) return line_;
    }
    return 0;
  }

 private:
  void count(char c) {
    if (c == '\n') ++line_;
    if (c == '[' || c == '{') ++open_;
    if (c == ']' || c == '}') --open_;
    if (c == '.') {
      ++dots_;
    } else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) {
      dots_ = 0;
    }
  }

  void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool many_lines = text_.substr(at_, 3) == three;
    at_ += many_lines ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n' && !many_lines) return;
      if (c == '\n') ++line_;
      if (c == quote && (!many_lines || text_.substr(at_, 3) == three)) {
        at_ += many_lines ? 3 : 1;
        return;
      }
      at_ += c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n' ? 2 : 1;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int open_ = 0;
  int dots_ = 0;
};

TomlValue copy(const toml::node& node);

TomlValue::List copy_list(const toml::array& array) {
  TomlValue::List list;
  list.reserve(array.size());
  for (const toml::node& item : array) list.push_back(copy(item));
  return list;
}

TomlValue::Table copy_table(const toml::table& table) {
  TomlValue::Table members;
  members.reserve(table.size());
  for (const auto& [key, node] : table) {
    const toml::source_position start = key.source().begin;
    members.push_back({std::string(key.str()), static_cast<int>(start.line),
                       static_cast<int>(start.column), copy(node)});
  }
  return members;
}

template <class Date>
TomlDate copy_date(const Date& date) {
  std::ostringstream text;
  text << date;
  return {text.str()};
}

TomlValue copy(const toml::node& node) {
  TomlValue value;
  value.line = static_cast<int>(node.source().begin.line);
  value.column = static_cast<int>(node.source().begin.column);
  node.visit([&value](const auto& typed) {
    if constexpr (toml::is_table<decltype(typed)>) {
      value.content = copy_table(typed);
    } else if constexpr (toml::is_array<decltype(typed)>) {
      value.content = copy_list(typed);
    } else if constexpr (toml::is_chronological<decltype(typed)>) {
      value.content = copy_date(typed.get());
    } else {
      value.content = typed.get();
    }
  });
  return value;
}

/// Cuts what is too long to read, and escapes what would break a line or a terminal.
std::string shown(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return printable(text);
  // Bytes 10xxxxxx continue a character: a cut before one would leave half of it.
  while (longest < text.size() && (static_cast<unsigned char>(text[longest]) & 0xC0) == 0x80) {
    ++longest;
  }
  return printable(text.substr(0, longest)) + (longest < text.size() ? "..." : "");
}

std::string toml_string(std::string_view text) {
  constexpr std::size_t longest_shown = 60;
  std::string escaped;
  for (const char c : text.substr(0, longest_shown + 4)) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return '"' + shown(escaped, longest_shown) + '"';
}

std::string written_list(const TomlValue::List& list) {
  constexpr std::size_t shown = 8;
  std::string out = "[";
  for (std::size_t i = 0; i < std::min(list.size(), shown); ++i) {
    const bool nested = std::holds_alternative<TomlValue::List>(list[i].content);
    out += (i == 0 ? "" : ", ") + (nested ? "[...]" : written(list[i]));
  }
  return out + (list.size() > shown ? ", ...]" : "]");
}

Issue whole_file_issue(int line, std::string rule, std::string hint) {
  return {line, "", "", std::move(rule), std::move(hint)};
}

}  // namespace

TomlText parse_toml(std::string_view text) {
  if (text.size() > limits::file_bytes) {
    const std::string rule =
        fmt::format("the file must not be larger than {} bytes", limits::file_bytes);
    return {{}, {whole_file_issue(0, rule, "check that this is the file you meant")}};
  }
  if (const int line = NestingScan(text).line_too_deep()) {
    const std::string rule = fmt::format(
        "tables, lists and dotted keys must not be nested more than {} deep", limits::nesting);
    return {{}, {whole_file_issue(line, rule, "no table of a design is nested this deep")}};
  }
  try {
    TomlText parsed{copy(toml::parse(text)), {}};
    parsed.root.line = 0;
    parsed.root.column = 0;
    return parsed;
  } catch (const toml::parse_error& error) {
    const int line = static_cast<int>(error.source().begin.line);
    const std::string rule =
        fmt::format("the text must be valid TOML, but: {}", shown(error.description(), 300));
    const char* hint =
        "mend this first; the rest of the file is read only once its syntax is right";
    return {{}, {whole_file_issue(line, rule, hint)}};
  }
}

std::string written(const TomlValue& value) {
  struct Writer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
    std::string operator()(double x) const { return written(x); }
    std::string operator()(const std::string& s) const { return toml_string(s); }
    std::string operator()(const TomlDate& date) const { return date.text; }
    std::string operator()(const TomlValue::List& list) const { return written_list(list); }
    std::string operator()(const TomlValue::Table& table) const {
      return table.empty() ? "{}" : "{...}";
    }
  };
  return std::visit(Writer{}, value.content);
}

std::string written_key(std::string_view key) {
  const auto is_bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  const bool bare = !key.empty() && key.size() <= limits::name_bytes &&
                    std::all_of(key.begin(), key.end(), is_bare);
  return bare ? std::string(key) : toml_string(key);
}

}  // namespace latticast
