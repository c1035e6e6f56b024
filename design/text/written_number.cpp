// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/text/written_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace latticast {
namespace {

using Digits = std::array<char, 64>;

/// "1.23e+04": one digit before the point.
std::string_view scientific(double value, int digits, Digits& room) {
  const auto end = std::to_chars(room.data(), room.data() + room.size(), value,
                                 std::chars_format::scientific, digits - 1);
  return {room.data(), end.ptr};
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string written(double value, int digits) {
  Digits room{};
  const std::string_view exact = scientific(value, digits, room);
  const std::size_t mark = exact.find('e');
  if (!std::isfinite(value) || mark == std::string_view::npos) return std::string(exact);
  const std::string_view after = exact.substr(exact[mark + 1] == '+' ? mark + 2 : mark + 1);
  int exponent = 0;
  std::from_chars(after.data(), after.data() + after.size(), exponent);
  if (exponent >= 15 || exponent < -9) {
    return without_trailing_zeros(std::string(exact.substr(0, mark))) +
           std::string(exact.substr(mark));
  }
  // As it is rounded: that may carry into another digit.
  double rounded = 0;
  std::from_chars(exact.data(), exact.data() + exact.size(), rounded);
  if (rounded == 0) return "0";
  Digits fixed{};
  const int decimals = std::max(0, digits - 1 - exponent);
  const auto end = std::to_chars(fixed.data(), fixed.data() + fixed.size(), rounded,
                                 std::chars_format::fixed, decimals);
  return without_trailing_zeros(std::string(fixed.data(), end.ptr));
}

std::string written(double value) {
  Digits room{};
  const auto end =
      std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::scientific);
  const std::string_view exact(room.data(), end.ptr);
  const std::string_view mantissa = exact.substr(0, exact.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
  return written(value, std::max(1, static_cast<int>(digits)));
}

}  // namespace latticast
