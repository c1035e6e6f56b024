// SPDX-License-Identifier: GPL-3.0-or-later
// What a link's shape is made from, and how files and messages write it. mm, MPa.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace latticast {

/// What a link's shape takes from its strand besides the path.
struct Strip {
  double width_mm = 0;
  double thickness_mm = 0;
  double youngs_modulus_mpa = 0;
  double chord_mm = 0;  ///< of one link
};

/// Sizes by their name with unit.
using LinkSizes = std::vector<std::pair<std::string_view, double>>;

struct LinkDescription {
  std::string_view name;  ///< of its path: "horseshoe"
  LinkSizes sizes;
};

}  // namespace latticast
