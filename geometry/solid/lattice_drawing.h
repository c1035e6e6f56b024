// SPDX-License-Identifier: GPL-3.0-or-later
// A segment's lattice in the unrolled plane, drawn and united at first demand, then kept: checks,
// flat pattern, solids and molds share it.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/plane_grid.h"
#include "geometry/solid/region.h"

namespace latticast {

/// For one thread at a time. What it returns stays until it is destroyed.
class LatticeDrawing {
 public:
  /// Keeps a reference. Precondition: a validated segment with a lattice.
  explicit LatticeDrawing(const Segment& segment) : segment_(segment) {}

  const Segment& segment() const { return segment_; }

  /// draw_lattice() of the segment. Straight strands are the same at every flatness. Throws as it
  /// does.
  const Pattern& strands(double flatness_mm);

  /// The strands with their inward corners rounded by the lattice's fillet; the strands themselves
  /// where it has none.
  const Pattern& outlines(double flatness_mm);

  /// unite() of the outlines. Throws as it does.
  const Region& united(double flatness_mm, const PlaneGrid& grid,
                       std::span<const std::int32_t> cuts, double closing_mm);

 private:
  // Flatness, sectors, their steps, steps along the segment, the two step lengths, cuts, closing.
  using UnionKey = std::tuple<double, int, std::int32_t, std::int32_t, double, double,
                              std::vector<std::int32_t>, double>;

  double effective_flatness_mm(double flatness_mm) const;

  const Segment& segment_;
  std::map<double, Pattern> strands_;  // by flatness
  std::map<double, Pattern> filleted_;
  std::map<UnionKey, Region> unions_;
};

}  // namespace latticast
