// SPDX-License-Identifier: GPL-3.0-or-later
// Strain of the lattice at every vertex of a mesh, for colours and reports.
#pragma once

#include <cstdint>
#include <vector>

#include "design/design.h"
#include "geometry/mesh/triangle_mesh.h"
#include "model/equilibrium/state.h"
#include "model/law/strand_law.h"

namespace latticast {

/// A vertex of a segment at rest, in the segment's own cylinder coordinates.
struct WallPoint {
  double radius_mm = 0;  ///< R of the layer's face where the mesh means that face
  double theta_rad = 0;
  double along_mm = 0;  ///< from the segment's base
};

/// A strand that holds a vertex.
struct StrandMember {
  int grid = -1;         ///< index of its family; -1: a ring
  int shape = -1;        ///< of StrandField::shapes; -1: straight
  double theta_rad = 0;  ///< of the strand's (chord) line at the vertex's height
};

/// Which strands of a lattice hold which vertices of its rest mesh. Holds for every state, and does
/// not point to anything outside of itself.
struct StrandField {
  Segment segment;
  std::vector<LinkShape> shapes;  ///< distinct links of the curved families
  std::vector<WallPoint> points;  ///< one per vertex
  /// Those of vertex i are members[first[i]] up to, not with, members[first[i + 1]]; one at least.
  std::vector<std::uint32_t> first;
  std::vector<StrandMember> members;
};

/// Finds the strands in the unrolled plane at R_c: all whose outline is at most `tolerance_mm` away
/// (the mesh's own), one of each family of straight strands; the nearest where none is (fillets).
/// `start_z_mm` is where the segment begins in the mesh's coordinates. Time linear in the vertices
/// for strands that overlap few of their family. Precondition: the segment has a lattice with a
/// strand or ring on it, and linear material. Throws UnsupportedDesign for another material.
StrandField strand_field(const Segment& segment, const TriangleMesh& rest, double start_z_mm,
                         double tolerance_mm);

/// Engineering strain of the lattice in a state, one per vertex, negative where compressed:
/// - rings: r/R - 1 at the vertex;
/// - straight strands: |F A| - 1 along their angle at the vertex (docs/model.md#energy);
/// - curved strands: that of the link's most stretched fibre (links.h) for its chord's strain
///   at R_c, all over the strand's section. Never negative; 0 where no state exists. Between 33
///   chord strains from the smallest to the largest it is interpolated linearly;
/// - where strands meet, the one of largest magnitude.
/// Where nothing bends, the largest is what `latticast check` compares with a limit. Under bending
/// a vertex lies beside its strand's line, by half of the width at most, and its strain differs by
/// up to |kappa| r w / (2 R sin alpha). Time linear in the vertices.
std::vector<double> strand_strains(const StrandField& field, const State& state);

/// The liner's largest principal stretch - 1 at every vertex of its rest mesh, made with the given
/// tolerance. Never negative.
std::vector<double> liner_strains(const Segment& segment, const TriangleMesh& rest,
                                  double start_z_mm, double tolerance_mm, const State& state);

}  // namespace latticast
