// SPDX-License-Identifier: GPL-3.0-or-later
// The mold in which a lattice is cast directly: a smooth core, a grooved shell in pieces, a base
// and a cap.
#pragma once

#include <optional>
#include <vector>

#include "molds/cannot_mold.h"
#include "molds/mold_piece.h"
#include "molds/shell.h"

namespace latticast {

class LatticeDrawing;

struct LatticeMoldOptions {
  MoldFit fit;
  std::optional<int> pieces;    ///< of the shell; absent: chosen from the undercuts
  double allowed_strain = 0.5;  ///< that the cast strands stand when a piece is pulled off
};

/// The mold before it is made solid: sizes are grown already.
struct LatticeMoldPlan {
  Segment segment;  ///< grown
  LatticeMoldOptions options;
  Shell shell;
  FillPlan fill;                    ///< in the shell's plane
  std::vector<Undercut> undercuts;  ///< in the shell's plane
  double land_mm = 0;               ///< of the shell before and behind the cavity
};

/// Draws the lattice, parts the shell and places sprues, vents and straps. A tolerance above a
/// fifth of the clearance is refined to that. Precondition: 2 pieces or more. Throws CannotMold (no
/// wall, no clearance, a clearance as large as the wall or the lattice's layer, pieces without
/// breadth), CannotDraw and GeometryError (cannot_draw.h, geometry_error.h).
LatticeMoldPlan plan_lattice_mold(LatticeDrawing& drawing, const LatticeMoldOptions& options);

/// Of a segment that is drawn for this mold alone.
LatticeMoldPlan plan_lattice_mold(const Segment& segment, const LatticeMoldOptions& options);

MoldExtent extent_of(const LatticeMoldPlan& plan);

/// The pieces: shell-1 to shell-N, core, base, cap. The cavity lies at 0 <= z <= the segment's
/// length and is the lattice, R_m <= R <= R_o. Every piece is one part; neighbouring pieces are the
/// clearance apart but for the faces on which they stand. Seams are moved a little, where edges
/// meet in a point; throws GeometryError if that does not help.
Mold lattice_mold(const LatticeMoldPlan& plan);

Mold lattice_mold(const Segment& segment, const LatticeMoldOptions& options);

}  // namespace latticast
