// SPDX-License-Identifier: GPL-3.0-or-later
// The mold in which a segment's liner is cast: a core, a shell of several pieces around it, and two
// plates that hold both.
#pragma once

#include "design/design.h"
#include "molds/mold_piece.h"

namespace latticast {

class LatticeDrawing;

inline constexpr double liner_flange_mm = 2;  ///< thickness of a flanged liner's flanges

struct LinerMoldOptions {
  MoldFit fit;
  LinerEnds ends = LinerEnds::open;
  bool keyed = false;  ///< the shell takes the finished lattice, and the liner is cast inside it
  int pieces = 2;      ///< of the shell
};

/// The cavity's sizes. Growth scales all of them, but for a keyed mold, where the finished lattice
/// gives the length and the shell's bore, and growth scales the core alone.
struct LinerCavity {
  double core_radius_mm = 0;    ///< inside of the liner
  double bore_radius_mm = 0;    ///< of the shell between the flanges: R_m; keyed: R_o + clearance/2
  double flange_radius_mm = 0;  ///< R_o, or the bore's where there are no flanges
  double flange_mm = 0;         ///< thickness of each flange
  double height_mm = 0;         ///< with flanges
  double closed_mm = 0;         ///< thickness of the closed end above the core; 0: open

  double volume_mm3() const;  ///< between core, shell and plates
};

/// Throws CannotMold where the options do not suit the segment: flanges or a keyed mold without a
/// lattice, or both together; a closed liner no longer than thick; a core as wide as its keyed
/// liner; fewer than two pieces, a wall that is not more than the clearance, or sizes that are not
/// positive.
LinerCavity liner_cavity(const Segment& segment, const LinerMoldOptions& options);

/// Of the mold that liner_mold() makes of the same. Throws CannotMold as it does.
MoldExtent extent_of(const Segment& segment, const LinerMoldOptions& options);

/// Pieces "core", "shell-1" ... "shell-N", "base" and "cap"; for a closed liner the core is part of
/// the base, which holds it straight.
///
/// - The core stands in the base's socket; `clearance` is left above it, in the cap's.
/// - The shell's pieces keep the clearance at their seams, measured along the bore, and have teeth
///   there that hold them at one height. Grooves on their outside take straps.
/// - The cap has three windows to pour through and for air; a closed liner's also has a round hole.
///   Of thin liners, they reach over the shell's rim and into the core's socket.
///
/// Guarantees: every piece is one body without handles, but for the cap's openings; no two pieces
/// overlap, and where they are put together half the clearance lies between their walls, whatever
/// the tolerance, which is made finer where the clearance or the liner asks for it. cavity_mm3 is
/// the cavity's volume, less the lattice's in a keyed mold.
/// Throws CannotMold as liner_cavity does, and where the pieces would be too narrow for their
/// seams; GeometryError, CannotDraw for a keyed mold (tube_solids.h).
/// `drawing` is the segment's, for a keyed mold; without one it is drawn for this mold alone.
Mold liner_mold(const Segment& segment, const LinerMoldOptions& options,
                LatticeDrawing* drawing = nullptr);

}  // namespace latticast
