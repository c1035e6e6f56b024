// SPDX-License-Identifier: GPL-3.0-or-later
// Why a mold cannot be made.
#pragma once

#include <stdexcept>

namespace latticast {

/// The mold cannot be made as asked; what() says why, with the numbers, and what to change.
struct CannotMold : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace latticast
