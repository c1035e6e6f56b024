// SPDX-License-Identifier: GPL-3.0-or-later
// Parting of a lattice mold's shell: where its seams run, and the undercuts by which its pieces
// catch on the cast strands.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/pattern/pattern.h"

namespace latticast {

/// A corner of one tooth of a seam: its shares of the teeth's reach and of their pitch.
struct ToothCorner {
  double reach = 0;
  double pitch = 0;
};

/// The middle line of a seam with teeth, z from 0 to `length_mm`: as many equal teeth as fit best
/// at the given pitch, at least one, with a straight piece at each end. It starts and ends at
/// `rest` times the reach.
std::vector<PlanePoint> toothed_line(double length_mm, double pitch_mm, double reach_mm,
                                     double rest, std::span<const ToothCorner> tooth);

/// Equal sectors with toothed seams, all seams alike. Piece k lies between seams k and k + 1 and is
/// pulled off straight outwards in the direction midway between them.
struct Parting {
  int pieces = 2;
  double first_seam_rad = 0;     ///< of seam 0's middle line
  double drawn_radius_mm = 0;    ///< where the plane is unrolled
  std::vector<PlanePoint> seam;  ///< from the lowest to the highest z; u beside the middle line
};

double seam_rad(const Parting& parting, int seam);
double pull_rad(const Parting& parting, int piece);

/// How far beside its middle line a seam is at a height.
double seam_offset_mm(const Parting& parting, double z_mm);

/// The piece that a point of the plane belongs to; clearances are left out.
int piece_at(const Parting& parting, PlanePoint point);

/// A groove wall that catches: the land beyond it must pass through the strand's side. A land at
/// the angle phi from the pull leaves the layer floor <= R <= ceiling after turning by
/// phi - asin(floor/ceiling sin phi), for thin layers depth x tan(phi) / R; its inner edge turns
/// furthest.
struct Undercut {
  int piece = 0;
  PlanePoint at;
  double around_mm = 0;        ///< overlap along u, at the drawn radius
  double undercut_mm = 0;      ///< the same, square to the strand
  double strand_width_mm = 0;  ///< across the strand from that wall
  double strain = 0;           ///< undercut / width: how much the strand must give way
};

/// The radii between which strands are cast.
struct CastLayer {
  double floor_mm = 0;
  double ceiling_mm = 0;
};

/// The worst place of every strand side in every piece that it passes, along the strand within
/// `spacing_mm`; empty where nothing catches. What lies inside of a ring is left out; sides that
/// other crossing strands hide are included.
std::vector<Undercut> undercut_map(const Pattern& strands, const Parting& parting,
                                   const CastLayer& layer, double spacing_mm = 0.25);

/// The place with the largest strain, all 0 for an empty map.
Undercut worst_undercut(const std::vector<Undercut>& map);

struct PartingWish {
  std::optional<int> pieces;  ///< absent: the fewest of 2 to 12 that keep the strain allowed, or of
                              ///< these the one with the least strain
  double allowed_strain = 0.5;
  double clearance_mm = 0.3;
  double tooth_mm = 1.5;  ///< a seam's teeth reach this far to either side of its middle line;
                          ///< less on narrow pieces, and on halves, which must pass the core
};

/// Turns the seams so that they run over as little strand as possible, thick and thin, and keep a
/// distance from strands that they do not cross: the best of 32 turns.
Parting choose_parting(const Pattern& strands, const PartingWish& wish, const CastLayer& layer);

}  // namespace latticast
