// SPDX-License-Identifier: GPL-3.0-or-later
// Line reader of text mesh files: lines, words, and numbers rounded to float32.
#pragma once

#include <cstddef>
#include <filesystem>
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
std::string in_quotes(std::string_view word);

/// The text behind a byte-order mark of UTF-8, or all of it. Throws FileError naming `file` for
/// text in UTF-16 or UTF-32, which such a mark tells of.
std::string_view without_byte_order_mark(const std::filesystem::path& file, std::string_view text);

/// Whether a word is another, which is in small letters, whatever the case of its letters.
bool is_word(std::string_view word, std::string_view small_letters);

enum class LineJoining { after_backslash, none };

/// Walks through text that must outlive it. Lines end with "\n" or "\r\n", or with "\r" where there
/// is no "\n"; one that ends with a backslash may go on in the next.
class LineReader {
 public:
  explicit LineReader(std::string_view text, LineJoining joining = LineJoining::after_backslash)
      : rest_(text),
        end_(text.find('\n') == std::string_view::npos ? '\r' : '\n'),
        joins_(joining == LineJoining::after_backslash) {}

  /// Goes to the next line; false at the end of the text.
  bool next_line();

  /// The next word of the line, empty at its end.
  std::string_view next_word();

  /// Of the line's (last) line, from 1.
  std::size_t line_number() const { return line_number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  char end_;
  bool joins_;
  std::size_t line_number_ = 0;
};

}  // namespace latticast
