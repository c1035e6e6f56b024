// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/core.h>

#include "design/joined.h"

namespace latticast {
namespace {

// No name that a design may use is longer; the rest of a longer one only costs time.
constexpr std::size_t longest_compared = 200;

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> before(width), above(width), row(width);
  for (std::size_t j = 0; j < width; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < width; ++j) {
      const int replaced = above[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool swapped =
          i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above.back();
}

std::vector<std::string> nearest_names(std::string_view typed,
                                       const std::vector<std::string>& known) {
  typed = typed.substr(0, longest_compared);
  const int near = std::max(2, static_cast<int>(typed.size()) / 3);
  std::vector<std::pair<int, std::string>> candidates;
  for (const std::string& name : known) {
    const int distance = edit_distance(typed, name);
    const bool continued = typed.size() >= 3 && std::string_view(name).starts_with(typed);
    // A name of one or two letters is "near" to every other such name.
    const bool close = distance <= near && distance < static_cast<int>(typed.size());
    if (close || continued) candidates.emplace_back(distance, name);
  }
  std::stable_sort(candidates.begin(), candidates.end());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, candidates.size()); ++i) {
    names.push_back(candidates[i].second);
  }
  return names;
}

std::string name_hint(std::string_view typed, const std::vector<std::string>& known,
                      std::string_view label) {
  const std::vector<std::string> near = nearest_names(typed, known);
  if (!near.empty()) return fmt::format("did you mean {}?", joined(near, " or "));
  if (known.empty()) return fmt::format("there are no {} here", label);
  return fmt::format("known {}: {}", label, joined(known, ", "));
}

}  // namespace latticast
