// SPDX-License-Identifier: GPL-3.0-or-later
// Which known names a mistyped one was probably meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace latticast {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (restricted Damerau-Levenshtein distance). Letter case does not count.
/// Time O(|a| |b|), memory O(|b|).
int edit_distance(std::string_view a, std::string_view b);

/// The names within a third of the typed name's length (but at least 2 edits), or that continue it,
/// nearest first; at most three. Empty when nothing is near.
std::vector<std::string> nearest_names(std::string_view typed,
                                       const std::vector<std::string>& known);

/// "did you mean A or B?" when something is near, otherwise "known LABEL: A, B, C".
std::string name_hint(std::string_view typed, const std::vector<std::string>& known,
                      std::string_view label);

}  // namespace latticast
