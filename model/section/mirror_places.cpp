// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/mirror_places.h"

#include <cstddef>

namespace latticast {
namespace {

/// Entry i: how many of the first widths are repeated by those that end with number i (Knuth,
/// Morris and Pratt, 1977).
std::vector<std::size_t> repeats(std::span<const double> widths) {
  std::vector<std::size_t> lengths(widths.size(), 0);
  for (std::size_t i = 1; i < widths.size(); ++i) {
    std::size_t length = lengths[i - 1];
    while (length > 0 && widths[i] != widths[length]) length = lengths[length - 1];
    lengths[i] = widths[i] == widths[length] ? length + 1 : 0;
  }
  return lengths;
}

}  // namespace

std::vector<bool> mirror_places(std::span<const double> widths) {
  const std::size_t n = widths.size();
  if (n == 0) return {};
  const std::vector<std::size_t> back_to = repeats(widths);
  std::vector<bool> places(n, false);
  // The widths are searched for in their own reverse, gone around twice.
  std::size_t matched = 0;
  for (std::size_t i = 0; i + 1 < 2 * n; ++i) {
    const double reversed = widths[(2 * n - i) % n];
    while (matched > 0 && widths[matched] != reversed) matched = back_to[matched - 1];
    if (widths[matched] == reversed) ++matched;
    if (matched < n) continue;
    const std::size_t begin = i + 1 - n;
    places[begin == 0 ? 0 : n - begin] = true;
    matched = back_to[matched - 1];
  }
  return places;
}

}  // namespace latticast
