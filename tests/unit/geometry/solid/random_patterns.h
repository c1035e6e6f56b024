// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns to try the unrolled plane on. The same number gives the same pattern on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/plane_grid.h"

namespace latticast {

/// Numbers that do not depend on the standard library's distributions.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

/// An angle of a family, likely to be trouble beside `other`: axial, supplementary, almost equal,
/// equal.
inline double random_angle(RandomNumbers& random, double other) {
  switch (random.whole(0, 7)) {
    case 0:
      return 90;
    case 1:
      return 180 - other;
    case 2:
      return other + 1e-3;
    case 3:
      return other;
    case 4:
      return random.between(89, 91);
    case 5:
      return 15.0 * random.whole(1, 11);
    default:
      return random.between(12, 168);
  }
}

/// Rings and up to three families of strips, some of them almost or exactly on top of each other.
inline Segment random_segment(RandomNumbers& random) {
  Segment segment;
  segment.length_mm = random.log_between(8, 80);
  segment.liner = {random.log_between(4, 20), 1, {}};
  segment.lattice = Lattice{random.between(0.5, 3), {}, std::nullopt, {}};
  const int rings = random.whole(0, 6);
  if (rings >= 2) {
    const double width = random.between(0.05, 0.8) * segment.length_mm / rings;
    segment.lattice->rings = Rings{rings, std::nullopt, width};
  }
  const double circumference = 2 * std::numbers::pi * segment.lattice_mid_radius_mm();
  double angle = random.between(20, 80);
  for (int i = random.whole(1, 3); i > 0; --i) {
    const int count = random.whole(1, 8);
    const double sine = std::sin(angle * std::numbers::pi / 180);
    const double width = random.between(0.02, 0.7) * circumference * sine / count;
    segment.lattice->grids.push_back({angle, std::vector<double>(count, width), StraightPath{}});
    angle = random_angle(random, angle);
  }
  return segment;
}

/// Convex polygons inside one period, corners on an ellipse: some large, some slivers.
inline Pattern random_polygons(RandomNumbers& random, double circumference, double length) {
  Pattern pattern{circumference, length, {}};
  for (int i = random.whole(2, 25); i > 0; --i) {
    const double half_u = random.log_between(0.02, 0.3) * circumference;
    const double half_z = random.log_between(0.02, 0.3) * length;
    const double u = random.between(1.01 * half_u, circumference - 1.01 * half_u);
    const double z = random.between(1.01 * half_z, length - 1.01 * half_z);
    std::vector<double> turns(random.whole(3, 7));
    for (double& turn : turns) turn = random.between(0, 2 * std::numbers::pi);
    std::sort(turns.begin(), turns.end());
    Strand strand;
    for (const double turn : turns) {
      strand.outline.push_back({u + half_u * std::cos(turn), z + half_z * std::sin(turn)});
    }
    pattern.strands.push_back(strand);
  }
  return pattern;
}

struct RandomPlane {
  Pattern pattern;
  PlaneGrid grid;
};

/// Every third pattern lies on a coarse grid, on which strips are a few dozen steps wide: there,
/// snapping has the most to do.
inline RandomPlane random_plane(std::uint64_t seed) {
  RandomNumbers random(seed);
  Pattern pattern =
      seed % 4 == 3 ? random_polygons(random, 60, 40) : draw_lattice(random_segment(random), 0.005);
  const double step = seed % 3 == 0 ? 0.01 : 2e-5;
  const PlaneGrid grid =
      make_plane_grid(pattern.circumference_mm, pattern.length_mm, random.whole(12, 40), step);
  return {std::move(pattern), grid};
}

}  // namespace latticast
