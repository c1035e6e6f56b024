// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/text/printable.h"

#include <cstdint>

namespace latticast {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 1;
};

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// Only as far as what is unprintable goes: two bytes from 0xC2 on, three from 0xE0 on.
Character character_at(std::string_view text, std::size_t i) {
  const std::uint32_t a = byte_at(text, i), b = byte_at(text, i + 1), c = byte_at(text, i + 2);
  const auto continues = [](std::uint32_t byte) { return (byte & 0xC0) == 0x80; };
  if (a >= 0xC2 && a < 0xE0 && continues(b)) return {(a & 0x1F) << 6 | (b & 0x3F), 2};
  if (a >= 0xE0 && a < 0xF0 && continues(b) && continues(c)) {
    return {(a & 0x0F) << 12 | (b & 0x3F) << 6 | (c & 0x3F), 3};
  }
  return {a < 0x80 ? a : 0xFFFD, 1};
}

Unprintable kind_of(std::uint32_t code) {
  if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return Unprintable::control;
  const bool hidden = code == 0x061C || code == 0x200B || code == 0x200E || code == 0x200F ||
                      (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x2069) ||
                      code == 0xFEFF;
  return hidden ? Unprintable::hidden : Unprintable::none;
}

void write_escaped(std::uint32_t code, std::string& out) {
  constexpr std::string_view digits = "0123456789abcdef";
  out += "\\u";
  for (const int shift : {12, 8, 4, 0}) out += digits[code >> shift & 0xF];
}

}  // namespace

Unprintable first_unprintable(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); i += character_at(text, i).size) {
    const Unprintable kind = kind_of(character_at(text, i).code);
    if (kind != Unprintable::none) return kind;
  }
  return Unprintable::none;
}

std::string printable(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Character next = character_at(text, i);
    const bool is_kept = next.size == 1 && kept.find(text[i]) != std::string_view::npos;
    if (is_kept || kind_of(next.code) == Unprintable::none) {
      out += text.substr(i, next.size);
    } else {
      write_escaped(next.code, out);
    }
    i += next.size;
  }
  return out;
}

}  // namespace latticast
