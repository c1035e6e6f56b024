// SPDX-License-Identifier: GPL-3.0-or-later
// Why what was drawn cannot be made a mesh.
#pragma once

#include <stdexcept>

namespace latticast {

/// The design needs more pieces than this program will hold in memory, or its strands graze each
/// other so finely that the grid cannot part them; what() says which.
struct GeometryError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace latticast
