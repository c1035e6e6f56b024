// SPDX-License-Identifier: GPL-3.0-or-later
// A segment's lattice in the unrolled plane, drawn and united at first demand, then kept: checks,
// flat pattern, solids and molds share it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/plane_grid.h"
#include "geometry/solid/region.h"
#include "geometry/solid/slivers.h"

namespace latticast {

/// For one thread at a time. What it returns stays until it is destroyed.
class LatticeDrawing {
 public:
  /// Keeps a reference. Slivers narrower than `sliver_mm` (slivers.h) are closed and parted where
  /// outlines are curved; a part's tolerance is right for it. 0: as drawn. Precondition: a
  /// validated segment with a lattice.
  explicit LatticeDrawing(const Segment& segment, double sliver_mm = 0)
      : segment_(segment), sliver_mm_(sliver_mm) {}

  const Segment& segment() const { return segment_; }
  double sliver_mm() const { return sliver_mm_; }

  /// The flatness at which the plane is looked at: 0.01 mm, or 1/20 of its finest feature if that
  /// is less.
  double usual_flatness_mm() const;

  /// The union as drawn at that flatness, slivers and all, on a grid for a plane that stays flat.
  const Region& drawn_union();

  /// Where slivers are; none where all outlines are straight.
  const std::vector<PlanePoint>& near_places();

  /// What is closed and parted in every drawing of this segment, whatever its flatness.
  const std::vector<Sliver>& slivers();

  /// draw_lattice() of the segment. Straight strands are the same at every flatness. Throws as it
  /// does.
  const Pattern& strands(double flatness_mm);

  /// The strands with their inward corners rounded by the lattice's fillet, and without slivers;
  /// the strands themselves where there are neither.
  const Pattern& outlines(double flatness_mm);

  /// unite() of the outlines. Throws as it does.
  const Region& united(double flatness_mm, const PlaneGrid& grid,
                       std::span<const std::int32_t> cuts, double closing_mm);

 private:
  // Flatness, sectors, their steps, steps along the segment, the two step lengths, cuts, closing.
  using UnionKey = std::tuple<double, int, std::int32_t, std::int32_t, double, double,
                              std::vector<std::int32_t>, double>;

  double effective_flatness_mm(double flatness_mm) const;
  const Pattern& rounded(double flatness_mm);

  const Segment& segment_;
  double sliver_mm_ = 0;
  std::optional<Region> drawn_union_;
  std::optional<std::vector<PlanePoint>> near_places_;
  std::optional<std::vector<Sliver>> slivers_;
  std::map<double, Pattern> mended_;   // by flatness
  std::map<double, Pattern> strands_;  // by flatness
  std::map<double, Pattern> filleted_;
  std::map<UnionKey, Region> unions_;
};

}  // namespace latticast
