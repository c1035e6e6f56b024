// SPDX-License-Identifier: GPL-3.0-or-later
// What every piece of a mold must be.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {

/// As read back from a file: it passes the audit, in one piece, with the genus and volume that its
/// maker promises.
inline void expect_sound(const Solid& solid, int genus) {
  const Audit result = audit(weld(solid.mesh));
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.components, 1);
  EXPECT_EQ(solid.pieces, 1);
  EXPECT_EQ(result.genus, genus);
  EXPECT_EQ(solid.genus, genus);
  EXPECT_NEAR(result.volume_mm3, solid.volume_mm3, solid.volume_bound_mm3);
}

}  // namespace latticast
