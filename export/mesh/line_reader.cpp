// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/line_reader.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "design/file_error.h"

namespace latticast {
namespace {

// Where lines are joined, the backslash and the line's end are blanks inside the line.
constexpr std::string_view blanks = " \t\r\v\f\\\n";

bool goes_on(std::string_view line) {
  return line.ends_with('\\') || line.ends_with("\\\r");
}

std::string_view without_plus(std::string_view word) {
  return word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
}

}  // namespace

std::optional<float> float32_of(std::string_view word) {
  word = without_plus(word);
  const char* const end = word.data() + word.size();
  float value = 0;
  auto parsed = std::from_chars(word.data(), end, value);
  if (parsed.ec == std::errc::result_out_of_range) {
    double wide = 0;
    parsed = std::from_chars(word.data(), end, wide);
    value = static_cast<float>(wide);
  }
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    return std::nullopt;
  }
  return value;
}

std::optional<double> float64_of(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
    return std::nullopt;
  }
  return value;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 60;
  std::string text = "\"";
  for (const char c : word.substr(0, longest)) {
    text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return text.append(word.size() > longest ? "…\"" : "\"");
}

std::string_view without_byte_order_mark(const std::filesystem::path& file, std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
      text.starts_with(std::string_view("\0\0\xFE\xFF", 4))) {
    throw FileError(file, "is text in UTF-16 or UTF-32: save it as UTF-8 or ASCII");
  }
  return text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

bool is_word(std::string_view word, std::string_view small_letters) {
  return word.size() == small_letters.size() &&
         std::equal(word.begin(), word.end(), small_letters.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

bool LineReader::next_line() {
  if (rest_.empty()) {
    return false;
  }
  std::size_t end = rest_.find(end_);
  for (++line_number_; joins_ && end != std::string_view::npos && goes_on(rest_.substr(0, end));
       ++line_number_) {
    end = rest_.find(end_, end + 1);
  }
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  return true;
}

std::string_view LineReader::next_word() {
  const std::size_t start = line_.find_first_not_of(blanks);
  if (start == std::string_view::npos) {
    return {};
  }
  line_.remove_prefix(start);
  const std::string_view word = line_.substr(0, line_.find_first_of(blanks));
  line_.remove_prefix(word.size());
  return word;
}

}  // namespace latticast
