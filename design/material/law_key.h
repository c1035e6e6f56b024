// SPDX-License-Identifier: GPL-3.0-or-later
// Constants of a material law as the design file spells them: one row of a law's key table.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "design/material/range.h"

namespace latticast {

/// One constant of the law `L`. Everything that reads, writes or scales constants walks these rows,
/// so that no other place names them.
template <class L>
struct LawKey {
  std::string_view key;
  std::string_view example;  ///< how a user would write it; empty: may be left out, and then the
                             ///< member keeps its default
  Range range;               ///< a unit of "MPa" marks what every stress is proportional to
  std::variant<double L::*, std::vector<double> L::*> member;
};

/// Ranges that several laws share.
inline constexpr Range modulus_range{.low = 1e-6, .high = 1e6, .unit = "MPa"};
inline constexpr Range signed_modulus_range{.low = -1e6, .high = 1e6, .unit = "MPa"};

/// Entries that a list of constants may hold.
inline constexpr int most_law_terms = 10;

}  // namespace latticast
