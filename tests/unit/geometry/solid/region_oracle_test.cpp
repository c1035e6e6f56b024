// SPDX-License-Identifier: GPL-3.0-or-later
// The union against CGAL's polygon sets in exact arithmetic, which share nothing with it.
#include <string>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <gtest/gtest.h>

#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/region.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

struct Truth {
  double area_mm2 = 0;
  int pieces = 0;  // in the unrolled plane: those that meet over the seam count twice
  int loops = 0;
};

Polygon shifted(const Strand& strand, const Number& by) {
  Polygon polygon;
  for (const PlanePoint& p : strand.outline) polygon.push_back({Number(p.u) + by, Number(p.z)});
  return polygon;
}

// The strands in every turn in which they reach into the period 0 <= u <= circumference.
std::vector<Polygon> unrolled_polygons(const Pattern& pattern) {
  std::vector<Polygon> polygons;
  const double period = pattern.circumference_mm;
  for (const Strand& strand : pattern.strands) {
    const auto [first, last] =
        std::minmax_element(strand.outline.begin(), strand.outline.end(),
                            [](const PlanePoint& a, const PlanePoint& b) { return a.u < b.u; });
    for (double turn = std::ceil(-last->u / period); turn * period + first->u < period; ++turn) {
      polygons.push_back(shifted(strand, Number(turn) * Number(period)));
    }
  }
  return polygons;
}

Truth exact_union(const Pattern& pattern) {
  const std::vector<Polygon> polygons = unrolled_polygons(pattern);
  PolygonSet all;
  all.join(polygons.begin(), polygons.end());
  const double period = pattern.circumference_mm;
  const double length = pattern.length_mm;
  all.intersection(shifted({{{0, 0}, {period, 0}, {period, length}, {0, length}}}, 0));

  std::vector<PolygonWithHoles> parts;
  all.polygons_with_holes(std::back_inserter(parts));
  Truth truth;
  Number area = 0;
  for (const PolygonWithHoles& part : parts) {
    area += part.outer_boundary().area();
    for (const Polygon& hole : part.holes()) area += hole.area();  // clockwise, so negative
    truth.loops += 1 + static_cast<int>(part.number_of_holes());
  }
  truth.pieces = static_cast<int>(parts.size());
  truth.area_mm2 = CGAL::to_double(area);
  return truth;
}

double outline_length(const Pattern& pattern) {
  double length = 0;
  for (const Strand& strand : pattern.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& a = strand.outline[i];
      const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
      length += std::hypot(b.u - a.u, b.z - a.z);
    }
  }
  return length;
}

TEST(RegionAgainstExactUnion, HasTheSameAreaForRandomPatterns) {
  constexpr std::uint64_t seed = 3001;
  double worst = 0;
  for (std::uint64_t i = 0; i < 160; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const Region region = unite(plane.pattern, plane.grid, {}, 1e-4);
    const double step = std::max(plane.grid.u_step_mm, plane.grid.z_step_mm);
    const double slack = outline_length(plane.pattern) * step;
    const double off = std::abs(area_mm2(region) - exact_union(plane.pattern).area_mm2);
    ASSERT_LE(off, slack);
    worst = std::max(worst, off / slack);
  }
  std::printf("seeds from %llu: largest difference %.3f of outline length x step\n",
              static_cast<unsigned long long>(seed), worst);
}

TEST(RegionAgainstExactUnion, HasTheSamePiecesAndHolesForRandomPolygons) {
  constexpr std::uint64_t seed = 3301;
  int holes = 0;
  for (std::uint64_t i = 0; i < 120; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Pattern pattern = random_polygons(random, 60, 40);
    const PlaneGrid grid = make_plane_grid(60, 40, random.whole(12, 40));
    const Region region = unite(pattern, grid, {}, 1e-4);
    const Truth truth = exact_union(pattern);
    EXPECT_EQ(outline_loops(region), truth.loops);
    EXPECT_EQ(pieces(triangulate(region)), truth.pieces);
    holes += truth.loops - truth.pieces;
  }
  EXPECT_GT(holes, 50) << "the patterns have too few holes to prove anything";
}

}  // namespace
}  // namespace latticast
