// SPDX-License-Identifier: GPL-3.0-or-later
// A word that the design file may hold, and what it means.
#pragma once

#include <string_view>

namespace latticast {

template <class Meaning>
struct Word {
  std::string_view name;
  Meaning meaning;
};

/// The word of a meaning; empty where it has none.
template <class Words, class Meaning>
constexpr std::string_view word_of(Meaning meaning, const Words& words) {
  for (const Word<Meaning>& word : words) {
    if (word.meaning == meaning) return word.name;
  }
  return {};
}

}  // namespace latticast
