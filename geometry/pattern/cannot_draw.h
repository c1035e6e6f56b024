// SPDX-License-Identifier: GPL-3.0-or-later
// Why a lattice cannot be drawn.
#pragma once

#include <stdexcept>

namespace latticast {

/// The design's strands cannot be drawn as asked; what() lists every reason with its place and the
/// nearest value that works.
struct CannotDraw : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace latticast
