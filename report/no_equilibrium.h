// SPDX-License-Identifier: GPL-3.0-or-later
// Why a preview cannot be made.
#pragma once

#include <stdexcept>

namespace latticast {

/// A preview asks for a pressure at which there is no equilibrium; what() names it and the limit
/// point.
struct NoEquilibrium : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace latticast
