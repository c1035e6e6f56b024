// SPDX-License-Identifier: GPL-3.0-or-later
// Segments that several tests share.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

#include "design/design.h"
#include "design/units.h"
#include "tests/random_numbers.h"

namespace latticast::testing {

inline constexpr double degree = pi / 180;

/// A bare tube.
inline Segment tube(double inner_mm, double outer_mm, const Law& law) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = inner_mm;
  segment.liner.thickness_mm = outer_mm - inner_mm;
  segment.liner.material.law = law;
  return segment;
}

inline Grid grid(double angle_deg, int count, double width_mm) {
  return {angle_deg, std::vector<double>(count, width_mm), StraightPath{}};
}

/// docs/model.md#published-and-calculated-numbers: liner 12-16, lattice 16-18, mu 0.08, E 19.46, 8
/// rings of 2 on 85 mm, and 8 strips of width 2 for each angle.
inline Segment paper_segment(std::initializer_list<double> angles_deg) {
  Segment segment = tube(12, 16, NeoHookean{0.08});
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.material.law = Linear{19.46, 0.5};
  lattice.rings = Rings{8, std::nullopt, 2};
  for (const double angle : angles_deg) lattice.grids.push_back(grid(angle, 8, 2));
  segment.lattice = lattice;
  return segment;
}

/// The same with one family and a ring each 10 mm, the tube of docs/unit-cell.md#accuracy.
inline Segment twisting_segment(double angle_deg) {
  Segment segment = paper_segment({angle_deg});
  segment.length_mm = 80;  // eight whole periods
  segment.lattice->material.law = Linear{19.46, 0.49};
  segment.lattice->rings = Rings{std::nullopt, 10.0, 2};
  return segment;
}

/// `count` widths, thick ones first on half of the tube.
inline std::vector<double> halves(int count, double thick, double thin) {
  std::vector<double> widths(count, thin);
  for (int j = 0; 2 * j < count; ++j) widths[j] = thick;
  return widths;
}

/// The paper's tube with one family of horseshoe strands; R_h = 85/32 mm puts 8 waves on 85 mm.
inline Segment columns(const std::vector<double>& widths, double angle_deg = 90,
                       Horseshoe horseshoe = {85.0 / 32, 180, true}) {
  Segment segment = paper_segment({});
  segment.lattice->grids.push_back({angle_deg, widths, horseshoe});
  return segment;
}

/// The bending of the whole length, degrees.
template <class State>
double bend_deg(const State& state, double length_mm = 85) {
  return state.bend_magnitude_rad_per_mm() * length_mm / degree;
}

inline ModelChoice with_joint(JointModel joint) {
  ModelChoice model;
  model.joint = joint;
  return model;
}

}  // namespace latticast::testing
