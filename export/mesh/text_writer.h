// SPDX-License-Identifier: GPL-3.0-or-later
// What writers of text mesh files share.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace latticast {

/// Appends a number as std::to_chars writes it: without a format, in the fewest digits that
/// identify it.
template <class Number, class... Format>
void append_number(std::string& text, Number value, Format... format) {
  std::array<char, 64> digits;  // the longest float32 without exponent takes 57 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format...);
  text.append(digits.data(), end.ptr);
}

/// A name as one word: blanks and control characters become "_"; "part" where it is empty.
inline std::string one_word(std::string_view name) {
  std::string word(name.empty() ? "part" : name);
  for (char& c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7F) c = '_';
  }
  return word;
}

}  // namespace latticast
