// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/setting/path_step.h"

#include <algorithm>
#include <charconv>

#include "design/limits.h"
#include "design/toml_text.h"

namespace latticast {
namespace {

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

std::string_view without_spaces(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t");
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find_last_not_of(" \t") + 1 - start);
}

// Walks over a path, step by step.
class PathParser {
 public:
  explicit PathParser(std::string_view text) : text_(text) {}

  ParsedPath parse() {
    do {
      if (!take_step()) {
        return fail(
            "a step is missing, or is no key: quote what has other signs than letters, digits, _ "
            "and -");
      }
      while (at_end_of("[")) {
        if (!take_bracket()) return fail("an entry of a list is written [0], counted from 0");
      }
    } while (at_end_of("."));
    if (at_ < text_.size()) return fail("a point goes between two steps");
    if (path_.steps.size() > limits::nesting) return fail("it has too many steps");
    return path_;
  }

 private:
  static ParsedPath fail(std::string problem) { return {{}, std::move(problem)}; }

  // Takes the sign where it stands.
  bool at_end_of(std::string_view sign) {
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  bool take_step() {
    const char first = at_ < text_.size() ? text_[at_] : '\0';
    if (first == '"' || first == '\'') {
      const std::size_t end = text_.find(first, at_ + 1);
      if (end == std::string_view::npos) return false;
      path_.steps.push_back({std::string(text_.substr(at_ + 1, end - at_ - 1)), true});
      at_ = end + 1;
      return true;
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && is_bare(text_[at_])) ++at_;
    path_.steps.push_back({std::string(text_.substr(start, at_ - start)), false});
    return at_ > start;
  }

  bool take_bracket() {
    const std::size_t end = text_.find(']', at_);
    if (end == std::string_view::npos) return false;
    path_.steps.push_back({std::string(text_.substr(at_, end - at_)), false});
    at_ = end + 1;
    return path_.steps.back().number().has_value();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  ParsedPath path_;
};

}  // namespace

std::optional<std::size_t> PathStep::number() const {
  std::size_t value = 0;
  const char* end = key.data() + key.size();
  const auto [last, fault] = std::from_chars(key.data(), end, value);
  if (is_quoted || key.empty() || fault != std::errc{} || last != end) return std::nullopt;
  return value;
}

SplitSetting split_setting(std::string_view setting) {
  char quote = '\0';
  for (std::size_t i = 0; i < setting.size(); ++i) {
    const char c = setting[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '=') {
      return {without_spaces(setting.substr(0, i)), without_spaces(setting.substr(i + 1))};
    }
  }
  return {setting, std::nullopt};
}

ParsedPath parse_path(std::string_view path) {
  return PathParser(path).parse();
}

std::string path_text(const std::vector<PathStep>& steps, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < std::min(count, steps.size()); ++i) {
    if (i > 0) text += '.';
    text += written_key(steps[i].key);
  }
  return text;
}

}  // namespace latticast
