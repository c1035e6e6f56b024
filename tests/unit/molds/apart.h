// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the pieces of a mold share no space.
#pragma once

#include <gtest/gtest.h>

#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "molds/mold_piece.h"

namespace latticast {

/// All pieces in one mesh pass the audit, which finds surfaces that cross (exact predicates) and
/// bodies inside others. Base and cap are lifted off by `lift_mm` first, because pieces that stand
/// on each other share a plane.
inline void expect_apart(const Mold& mold, double lift_mm) {
  TriangleMesh all;
  int genus = 0;
  for (const MoldPiece& piece : mold.pieces) {
    const double up = piece.name == "base" ? -lift_mm : piece.name == "cap" ? lift_mm : 0;
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Point& p : piece.solid.mesh.vertices) {
      all.vertices.push_back({p[0], p[1], p[2] + up});
    }
    for (const Triangle& t : piece.solid.mesh.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    genus += piece.solid.genus;
  }
  const Audit result = audit(weld(all));
  for (const Finding& finding : result.findings) {
    ADD_FAILURE() << name(finding.defect) << " at " << finding.where[0] << ", " << finding.where[1]
                  << ", " << finding.where[2];
  }
  EXPECT_EQ(result.components, static_cast<int>(mold.pieces.size()));
  EXPECT_EQ(result.genus, genus);
}

}  // namespace latticast
