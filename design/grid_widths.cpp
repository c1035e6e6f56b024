// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/grid_widths.h"

#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace latticast {

std::vector<double> graded_widths_mm(double from_mm, double to_mm, WidthProfile profile,
                                     int count) {
  std::vector<double> widths(count);
  for (int j = 0; j < count; ++j) {
    const double phi = 2 * std::numbers::pi * j / count;
    const double cosine = 0.5 * (from_mm + to_mm) + 0.5 * (from_mm - to_mm) * std::cos(phi);
    const double half = 2 * j < count ? from_mm : to_mm;
    widths[j] = profile == WidthProfile::cosine ? cosine : half;
  }
  return widths;
}

std::vector<double> read_listed_widths(const Field& field, std::optional<int> count) {
  std::vector<double> widths = field.numbers(1, limits::strands_or_rings, limits::length);
  if (count && !widths.empty() && static_cast<int>(widths.size()) != *count) {
    field.refuse(
        fmt::format("must hold one width per strand: {} for {} strands", widths.size(), *count),
        "change the count or the list; with a list, count may be left out");
    return {};
  }
  return widths;
}

std::vector<double> read_graded_widths(const Field& field, int count) {
  constexpr Word<WidthProfile> words[] = {{"cosine", WidthProfile::cosine},
                                          {"halves", WidthProfile::halves}};
  TableReader table = field.as_table("");
  const double from_mm = table.need("from", "from = 2").number(limits::length);
  const double to_mm = table.need("to", "to = 4").number(limits::length);
  const WidthProfile profile =
      table.need("profile", R"(profile = "cosine")").word_or(WidthProfile::cosine, words);
  table.refuse_unknown_keys();
  return graded_widths_mm(from_mm, to_mm, profile, count);
}

}  // namespace latticast
