// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pressure_list.h"

#include <charconv>
#include <stdexcept>

#include <fmt/core.h>

#include "design/limits.h"
#include "design/pressure_sweep.h"

namespace latticast {
namespace {

constexpr double most_pressures = 100'000;

[[noreturn]] void refuse(std::string_view text, std::string_view rule) {
  throw std::invalid_argument(
      fmt::format("--pressure {}: {}; write one pressure in kPa (30), a list (10,20,30) or "
                  "FROM:TO:STEP (0:60:5)",
                  text, rule));
}

double parse_one(std::string_view part, std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (fault != std::errc{} || end != part.data() + part.size()) {
    refuse(text, fmt::format("'{}' is not a number", part));
  }
  if (!limits::pressure.contains(value)) {
    refuse(text, fmt::format("{} is outside {} to {} kPa", part, limits::pressure.low,
                             limits::pressure.high));
  }
  return value;
}

std::vector<double> parse_parts(std::string_view text, char separator) {
  std::vector<double> values;
  for (std::string_view rest = text;;) {
    const std::size_t end = rest.find(separator);
    values.push_back(parse_one(rest.substr(0, end), text));
    if (end == std::string_view::npos) return values;
    rest.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<double> parse_pressures_kpa(std::string_view text) {
  if (text.find(':') == std::string_view::npos) return parse_parts(text, ',');
  const std::vector<double> parts = parse_parts(text, ':');
  if (parts.size() != 3) refuse(text, "a range has three parts");
  const PressureSweep sweep{parts[0], parts[1], parts[2]};
  const double size = sweep_size(sweep);
  if (size < 1) refuse(text, "the step never leads from the first to the last pressure");
  if (size > most_pressures) refuse(text, fmt::format("more than {} pressures", most_pressures));
  return sweep_pressures_kpa(sweep);
}

}  // namespace latticast
