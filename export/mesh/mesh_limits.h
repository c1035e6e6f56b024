// SPDX-License-Identifier: GPL-3.0-or-later
// What files that place a mesh many times may ask for.
#pragma once

#include <cstddef>

namespace latticast {

/// A file of a few kilobytes can name gigabytes. It is refused before they are taken.
struct MeshLimits {
  std::size_t depth = 64;            ///< of objects in objects
  std::size_t components = 100000;   ///< objects in objects, all together
  std::size_t items = 100000;        ///< what is placed for printing
  std::size_t uses = 100000;         ///< meshes as they are placed in the end
  std::size_t triangles = 20000000;  ///< of all of these
};

}  // namespace latticast
