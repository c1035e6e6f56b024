// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace latticast {

/// The design is valid, but asks for what this version does not do; what() says what and what to
/// change.
struct UnsupportedDesign : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How messages name a segment's grid: from 1, the index from 0.
inline std::string grid_name(std::size_t index) {
  return "grid " + std::to_string(index + 1);
}

}  // namespace latticast
