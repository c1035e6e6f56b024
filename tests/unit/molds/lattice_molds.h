// SPDX-License-Identifier: GPL-3.0-or-later
// Segments to cast, and what every lattice mold must be.
#pragma once

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "molds/lattice_mold.h"
#include "tests/unit/molds/sound_solid.h"

namespace latticast {

/// Liner 12 to 16, lattice 16 to 18, 85 long, eight rings of 2: the paper's tube, without strands.
inline Segment ringed_segment() {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice = Lattice{2, {}, Rings{8, std::nullopt, 2}, {}};
  return segment;
}

inline Segment twisting_segment() {
  Segment segment = ringed_segment();
  segment.lattice->grids = {{36, std::vector<double>(8, 2.0), StraightPath{}}};
  return segment;
}

/// Eight columns of 2 and eight of 3: examples/bending.
inline Segment bending_segment() {
  Segment segment = ringed_segment();
  std::vector<double> widths(8, 2.0);
  widths.insert(widths.end(), 8, 3.0);
  segment.lattice->grids = {{90, widths, Horseshoe{2.65625, 180, true}}};
  return segment;
}

/// Tilted horseshoe columns with graded widths: examples/superimposed.
inline Segment superimposed_segment() {
  Segment segment = ringed_segment();
  std::vector<double> widths(8);
  for (int i = 0; i < 8; ++i) widths[i] = 3 - std::cos(i * std::acos(-1.0) / 4);
  segment.lattice->grids = {{60, widths, Horseshoe{3.067, 180, true}}};
  return segment;
}

/// Axial columns without rings: as many cavities as columns, each with two ends.
inline Segment column_segment(int count = 6, double width = 2) {
  Segment segment = ringed_segment();
  segment.lattice->rings.reset();
  segment.lattice->grids = {{90, std::vector<double>(count, width), StraightPath{}}};
  return segment;
}

/// The mold put together, with the faces on which pieces stand lifted apart by a micrometre.
inline TriangleMesh assembled(const Mold& mold) {
  TriangleMesh all;
  for (const MoldPiece& piece : mold.pieces) {
    double lift = 0;
    if (piece.name == "base") lift = -1e-3;
    if (piece.name == "core") lift = -0.5e-3;
    if (piece.name == "cap") lift = 1e-3;
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Point& p : piece.solid.mesh.vertices) {
      all.vertices.push_back({p[0], p[1], p[2] + lift});
    }
    for (const Triangle& t : piece.solid.mesh.triangles) {
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  return all;
}

/// Every piece is sound and all of them are disjoint: no two triangles of the assembly meet, and no
/// body lies inside another.
inline void expect_sound_mold(const Mold& mold) {
  for (const MoldPiece& piece : mold.pieces) {
    SCOPED_TRACE(piece.name);
    expect_sound(piece.solid, piece.solid.genus);
  }
  const Audit together = audit(weld(assembled(mold)));
  EXPECT_TRUE(together.passes());
  EXPECT_EQ(together.components, static_cast<int>(mold.pieces.size()));
}

}  // namespace latticast
