// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/fillet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/region.h"

namespace latticast {
namespace {

constexpr double around = 60;
constexpr double length = 40;
constexpr double flatness = 0.001;

Strand box(double u0, double u1, double z0, double z1) {
  return {{{u0, z0}, {u1, z0}, {u1, z1}, {u0, z1}}};
}

// A ring, and columns that cross it: four right-angled inward corners each.
Pattern crosses(const std::vector<double>& places, double half_width) {
  Pattern pattern{around, length, {box(0, around, 15, 17)}};
  for (const double u : places) {
    pattern.strands.push_back(box(u - half_width, u + half_width, 0, length));
  }
  return pattern;
}

Region region_of(const Pattern& pattern) {
  return unite(pattern, make_plane_grid(around, length, 24), {}, 1e-4);
}

double filled_area(const Pattern& pattern, double radius) {
  return area_mm2(region_of(with_fillets(pattern, radius, flatness)));
}

TEST(Fillet, AddsTheCornersOfASquareAroundACircle) {
  const double plain = area_mm2(region_of(crosses({10, 30}, 1)));
  for (const double radius : {0.1, 0.5, 2.0, 5.0}) {
    SCOPED_TRACE(radius);
    const double added = 8 * radius * radius * (1 - std::numbers::pi / 4);
    // A fillet's chords lie within the flatness of its quarter circle.
    const double slack = 8 * flatness * radius * std::numbers::pi / 2 + 1e-3;
    EXPECT_NEAR(filled_area(crosses({10, 30}, 1), radius) - plain, added, slack);
  }
}

TEST(Fillet, DoesNotSeeTheSeam) {
  const double inside = filled_area(crosses({10, 30}, 1), 2);
  for (const double shift : {-10.0, -9.0, 20.0, 28.5, 29.0, 30.0, 31.0, 650.0}) {
    SCOPED_TRACE(shift);
    const Pattern moved = with_fillets(crosses({10 + shift, 30 + shift}, 1), 2, flatness);
    const Region region = region_of(moved);
    EXPECT_NEAR(area_mm2(region), inside, 2e-3);
    EXPECT_EQ(outline_loops(region), 2);  // on either side of the ring
    EXPECT_EQ(pieces(triangulate(region)), 1);
  }
}

TEST(Fillet, ClosesGapsNarrowerThanItsDiameter) {
  // Two columns 3 apart: closed by a radius of 1.6, open with 1.4.
  const Pattern pattern = crosses({28, 33}, 1);
  const double plain = area_mm2(region_of(pattern));
  const double gaps = 3 * (length - 2);
  EXPECT_LT(filled_area(pattern, 1.4) - plain, 0.1 * gaps);
  EXPECT_GT(filled_area(pattern, 1.6) - plain, 0.9 * gaps);
  // In front of the ends the disc still reaches in between the columns: by 1.6 - 0.5546.
  const double sagitta = 1.6 - std::sqrt(1.6 * 1.6 - 1.5 * 1.5);
  const Pattern closed = with_fillets(pattern, 1.6, flatness);
  double deepest = 0;
  for (const Strand& strand : closed.strands) {
    for (const PlanePoint& p : strand.outline) {
      if (p.u > 29.5 && p.u < 31.5 && p.z < 10) deepest = std::max(deepest, p.z);
    }
  }
  EXPECT_NEAR(deepest, sagitta, 2 * flatness);
}

TEST(Fillet, LeavesOutwardCornersAndEndsAlone) {
  Pattern slab{
      around, length, {box(10, 20, 5, 12), {{{30, 0}, {34, 0}, {44, length}, {40, length}}}}};
  const Pattern result = with_fillets(slab, 3, flatness);
  EXPECT_NEAR(area_mm2(region_of(result)), 70 + 160, 1e-3);
  for (const Strand& strand : slab.strands) {
    for (const PlanePoint& corner : strand.outline) {
      double nearest = HUGE_VAL;
      for (const Strand& drawn : result.strands) {
        for (const PlanePoint& p : drawn.outline) {
          nearest = std::min(nearest, std::hypot(p.u - corner.u, p.z - corner.z));
        }
      }
      EXPECT_LT(nearest, 0.5 * flatness) << corner.u << " " << corner.z;
    }
  }
}

TEST(Fillet, MuchLargerThanTheGapsFillsThemAll) {
  const Region region = region_of(with_fillets(crosses({5, 15, 25, 35, 45, 55}, 1), 9, flatness));
  EXPECT_EQ(pieces(triangulate(region)), 1);
  EXPECT_EQ(outline_loops(region), 2);
}

TEST(Fillet, FinerThanItsStepsChangesNothing) {
  const Pattern pattern = crosses({10}, 1);
  const Pattern result = with_fillets(pattern, 1e-6, flatness);
  ASSERT_EQ(result.strands.size(), pattern.strands.size());
}

TEST(Fillet, OfASegmentFarShorterThanItIsWide) {
  const Pattern thin{6e5, 1e-3, {{{{0, 0}, {10, 0}, {10, 1e-3}, {0, 1e-3}}}}};
  for (const Strand& strand : with_fillets(thin, 1, 0.01).strands) {
    for (const PlanePoint& p : strand.outline) EXPECT_TRUE(p.z >= 0 && p.z <= 1e-3);
  }
}

}  // namespace
}  // namespace latticast
