// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers of a strand path for files and messages. Lengths mm, angles degrees.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace latticast {

struct PathDescription {
  std::string_view name;      ///< its key in the design file; "straight" for the chord line
  std::string_view noun;      ///< one strand of it: "a horseshoe"
  std::string text;           ///< "arcs of 180 degrees, radius 2.6 mm"; empty for the chord line
  std::string_view more;      ///< what gives it a longer way to full extension
  std::string_view narrower;  ///< what brings it nearer to its chord line
  using Value = std::variant<double, bool>;
  std::vector<std::pair<std::string_view, Value>> parameters;  ///< name with unit, value
};

}  // namespace latticast
