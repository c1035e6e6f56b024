// SPDX-License-Identifier: GPL-3.0-or-later
// Line reader of text mesh files: lines, words, and numbers rounded to float32.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace latticast {

/// The number that `word` is, rounded to float32: exactly the nearest one, infinity beyond its
/// range. Takes a leading "+", exponents, "inf" and "nan"; nothing when the word is anything else.
std::optional<float> float32_of(std::string_view word);

/// The same as a double.
std::optional<double> float64_of(std::string_view word);

/// A word of a file for a message: in quotes, and cut short where it is long.
std::string quoted(std::string_view word);

/// Walks through text that must outlive it. Lines end with "\n" or "\r\n"; one that ends with a
/// backslash goes on in the next.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// Goes to the next line; false at the end of the text.
  bool next_line();

  /// The next word of the line, empty at its end.
  std::string_view next_word();

  /// Of the line's (last) line, from 1.
  std::size_t line_number() const { return line_number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t line_number_ = 0;
};

}  // namespace latticast
