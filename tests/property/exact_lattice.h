// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice as its design means it: straight sides, true arcs, true fillets. Written apart from the
// program's drawing and meshing, to measure them against.
#pragma once

#include <vector>

#include "design/design.h"

namespace latticast {

/// How deep a place lies inside the lattice, in the plane unrolled at R_c, and in which direction
/// the depth grows.
struct Depth {
  double mm = 0;  ///< positive inside: distance from the outline, of which the ends are part
  double along_u = 0;
  double along_z = 0;
};

class ExactLattice {
 public:
  explicit ExactLattice(const Segment& segment);

  /// Exact for places within `reach_mm` of an outline; deeper ones are at least that deep.
  Depth depth(double u, double z, double reach_mm) const;

  /// Without fillets, to rounding. Strands must not share a side.
  double area_mm2() const;

 private:
  // u = start + z cot(angle), half as wide along u.
  struct Strip {
    double start, cotangent, half;
  };
  struct Ring {
    double low, high;
  };
  // A band along a circle, from angle to angle; a disc has no inner radius.
  struct Arc {
    double u, z, inner, outer, from, to;
    double middle() const { return 0.5 * (from + to); }
  };
  // What bounds the lattice: a straight side in 0 <= z <= length, or a part of a circle.
  struct Side {
    bool round;
    double start, cotangent;        // straight
    double u, z, radius, from, to;  // round
    bool outer;                     // material on the left of it or inside of it
    std::size_t shape;              // which strip or arc it belongs to
  };
  struct End {
    double z, from, to;  // material from u to u at an end
  };

  void add_strip(const Grid& grid, int strand);
  void add_horseshoes(const Grid& grid, int strand);
  void add_sides();
  void add_ends();
  double wrapped(double u) const;
  bool in_strip(const Strip& strip, double u, double z) const;
  bool in_arc(const Arc& arc, double u, double z) const;
  bool covered(double u, double z, std::size_t but_shape, std::size_t but_ring) const;
  Depth depth_in_strip(const Strip& strip, double u, double z) const;
  Depth depth_in_arc(const Arc& arc, double u, double z) const;
  Depth plain_depth(double u, double z) const;
  Depth filleted_depth(double u, double z, double reach) const;
  double gap_to_material(double u, double z) const;
  std::vector<double> crossings(const Side& side, const Side& other) const;
  std::vector<double> level_crossings(double z) const;
  double area_of(const Side& side) const;
  double level_length(double z, std::size_t but_ring, bool wants_covered) const;

  double circumference_;
  double length_;
  double fillet_;
  std::vector<Strip> strips_;
  std::vector<Ring> rings_;
  std::vector<Arc> arcs_;
  std::vector<Side> sides_;
  std::vector<End> ends_;
};

}  // namespace latticast
