// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace latticast {

/// The design is valid, but asks for what this version does not do; what() says what and what to
/// change.
struct UnsupportedDesign : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace latticast
