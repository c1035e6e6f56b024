// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/arrangement.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/geometry_error.h"
#include "geometry/solid/relief.h"
#include "tests/unit/geometry/solid/random_patterns.h"
#include "tests/unit/geometry/solid/square_patterns.h"

namespace latticast {
namespace {

__extension__ using Wide = __int128;

Wide exact_turn(GridPoint a, GridPoint b, GridPoint c) {
  return Wide{b.u - a.u} * (c.z - a.z) - Wide{b.z - a.z} * (c.u - a.u);
}

// Position of a point along an edge: 0 at a, squared_length at b.
Wide along(const ArrangedEdge& e, GridPoint p) {
  return Wide{e.b.u - e.a.u} * (p.u - e.a.u) + Wide{e.b.z - e.a.z} * (p.z - e.a.z);
}

Wide squared_length(const ArrangedEdge& e) {
  return along(e, e.b);
}

int sign(Wide x) {
  return (x > 0) - (x < 0);
}

bool cross(const ArrangedEdge& e, const ArrangedEdge& f) {
  return sign(exact_turn(e.a, e.b, f.a)) * sign(exact_turn(e.a, e.b, f.b)) < 0 &&
         sign(exact_turn(f.a, f.b, e.a)) * sign(exact_turn(f.a, f.b, e.b)) < 0;
}

bool overlap(const ArrangedEdge& e, const ArrangedEdge& f) {
  if (exact_turn(e.a, e.b, f.a) != 0 || exact_turn(e.a, e.b, f.b) != 0) return false;
  const Wide low = std::min(along(e, f.a), along(e, f.b));
  const Wide high = std::max(along(e, f.a), along(e, f.b));
  return std::max(low, Wide{0}) < std::min(high, squared_length(e));
}

// Less than one step from the edge's inside.
bool crowds(GridPoint p, const ArrangedEdge& e) {
  if (p == e.a || p == e.b) return false;
  const Wide position = along(e, p);
  if (position <= 0 || position >= squared_length(e)) return false;
  const Wide off = exact_turn(e.a, e.b, p);
  return off * off < squared_length(e);
}

std::string text(GridPoint p) {
  return "(" + std::to_string(p.u) + ", " + std::to_string(p.z) + ")";
}

std::string text(const ArrangedEdge& e) {
  return text(e.a) + " - " + text(e.b);
}

// All ends that concern a sector: its own, and its neighbours' on the lines that it shares with
// them.
std::set<GridPoint> ends_in_sector(const Arrangement& plane, int c) {
  const int count = plane.grid.sectors;
  const std::int32_t width = plane.grid.sector_steps;
  std::set<GridPoint> ends;
  for (const ArrangedEdge& edge : plane.sectors[c]) ends.insert({edge.a, edge.b});
  for (const ArrangedEdge& edge : plane.sectors[(c + count - 1) % count]) {
    if (edge.b.u == width) ends.insert({0, edge.b.z});
  }
  for (const ArrangedEdge& edge : plane.sectors[(c + 1) % count]) {
    if (edge.a.u == 0) ends.insert({width, edge.a.z});
  }
  return ends;
}

void expect_clean_edges(const Arrangement& plane, const std::vector<ArrangedEdge>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ArrangedEdge& e = edges[i];
    ASSERT_LT(e.a, e.b);
    ASSERT_TRUE(e.a.u >= 0 && e.b.u <= plane.grid.sector_steps) << text(e);
    ASSERT_TRUE(std::min(e.a.z, e.b.z) >= 0 && std::max(e.a.z, e.b.z) <= plane.grid.length_steps)
        << text(e);
    const bool on_line = e.a.u == e.b.u && (e.a.u == 0 || e.a.u == plane.grid.sector_steps);
    ASSERT_FALSE(on_line) << text(e);
    for (std::size_t j = 0; j < i; ++j) {
      const ArrangedEdge& f = edges[j];
      if (e.b.u < f.a.u || f.b.u < e.a.u) continue;
      ASSERT_FALSE(cross(e, f)) << text(e) << " crosses " << text(f);
      ASSERT_FALSE(overlap(e, f)) << text(e) << " overlaps " << text(f);
    }
  }
}

void expect_clean(const Arrangement& plane) {
  ASSERT_EQ(plane.sectors.size(), static_cast<std::size_t>(plane.grid.sectors));
  for (int c = 0; c < plane.grid.sectors; ++c) {
    SCOPED_TRACE("sector " + std::to_string(c));
    const auto& edges = plane.sectors[c];
    ASSERT_NO_FATAL_FAILURE(expect_clean_edges(plane, edges));
    const std::set<GridPoint> ends = ends_in_sector(plane, c);
    for (const ArrangedEdge& edge : edges) {
      for (auto p = ends.lower_bound({edge.a.u - 1, INT32_MIN});
           p != ends.end() && p->u <= edge.b.u + 1; ++p) {
        ASSERT_FALSE(crowds(*p, edge)) << text(*p) << " crowds " << text(edge);
      }
    }
  }
}

// How far the arrangement's ends lie from the outlines that were given, in steps, at most.
double farthest_from_outlines(const Arrangement& plane, const Pattern& pattern) {
  struct Side {
    double u, z, du, dz;
  };
  std::vector<Side> sides;
  const double period = static_cast<double>(plane.grid.sectors) * plane.grid.sector_steps;
  for (const Strand& strand : pattern.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& a = strand.outline[i];
      const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
      sides.push_back({a.u / plane.grid.u_step_mm, a.z / plane.grid.z_step_mm,
                       (b.u - a.u) / plane.grid.u_step_mm, (b.z - a.z) / plane.grid.z_step_mm});
    }
  }
  const auto distance_squared = [](const Side& side, double u, double z) {
    const double part =
        ((u - side.u) * side.du + (z - side.z) * side.dz) / (side.du * side.du + side.dz * side.dz);
    const double inside = std::clamp(part, 0.0, 1.0);
    const double off_u = side.u + inside * side.du - u;
    const double off_z = side.z + inside * side.dz - z;
    return off_u * off_u + off_z * off_z;
  };
  double farthest = 0;
  for (int c = 0; c < plane.grid.sectors; ++c) {
    for (const ArrangedEdge& edge : plane.sectors[c]) {
      const double u = edge.a.u + static_cast<double>(c) * plane.grid.sector_steps;
      double nearest = HUGE_VAL;
      for (const Side& side : sides) {
        const double low = std::min(side.u, side.u + side.du) - 100;
        const double high = std::max(side.u, side.u + side.du) + 100;
        for (double at = u + std::ceil((low - u) / period) * period; at <= high; at += period) {
          nearest = std::min(nearest, distance_squared(side, at, edge.a.z));
        }
      }
      farthest = std::max(farthest, std::sqrt(nearest));
    }
  }
  return farthest;
}

TEST(Arrangement, OfRandomPatternsMeetsAtGridPointsOnly) {
  constexpr std::uint64_t seed = 7001;
  std::size_t edges = 0;
  double farthest = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const Arrangement arranged = arrange(plane.pattern, plane.grid);
    ASSERT_NO_FATAL_FAILURE(expect_clean(arranged));
    const double moved = farthest_from_outlines(arranged, plane.pattern);
    EXPECT_LT(moved, 4) << "steps";
    farthest = std::max(farthest, moved);
    for (const auto& sector : arranged.sectors) edges += sector.size();
  }
  std::printf("seeds from %llu: %zu edges, none moved by more than %.3f steps\n",
              static_cast<unsigned long long>(seed), edges, farthest);
}

TEST(Arrangement, WithCutHeightsKeepsTheCutsLevel) {
  constexpr std::uint64_t seed = 7501;
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    std::vector<std::int32_t> cuts;
    for (int k = 1; k < 9; ++k) cuts.push_back(k * (plane.grid.length_steps / 9));
    const Arrangement arranged = arrange(plane.pattern, plane.grid, cuts);
    ASSERT_NO_FATAL_FAILURE(expect_clean(arranged));
    EXPECT_EQ(arranged.cuts, cuts);
    for (const auto& sector : arranged.sectors) {
      for (const std::int32_t cut : cuts) {
        std::int32_t covered = 0;
        for (const ArrangedEdge& edge : sector) {
          const auto [low, high] = std::minmax(edge.a.z, edge.b.z);
          EXPECT_FALSE(low < cut && cut < high) << text(edge) << " passes the cut at " << cut;
          if (low == cut && high == cut) covered += edge.b.u - edge.a.u;
        }
        EXPECT_EQ(covered, plane.grid.sector_steps) << "the cut at " << cut << " has gaps";
      }
    }
  }
}

TEST(Arrangement, CutsJustAboveASectorLineLeaveNoEdgeOnTheLine) {
  // The outline leaves the line so steeply that the cut's point on it rounds back onto the line.
  const Pattern pattern = on_square_grid({{{1024, 0}, {2500, 0}, {2503, 1024}, {1027, 1024}}});
  const std::vector<std::int32_t> cuts{100};
  ASSERT_NO_FATAL_FAILURE(expect_clean(arrange(pattern, square_grid(), cuts)));
}

TEST(Arrangement, OfTheSameFamilyTwiceAddsItsWindings) {
  RandomNumbers random(3);
  const Pattern once = draw_lattice(random_segment(random), 0.005);
  Pattern twice = once;
  twice.strands.insert(twice.strands.end(), once.strands.begin(), once.strands.end());
  const PlaneGrid grid = make_plane_grid(once.circumference_mm, once.length_mm, 30);
  const Arrangement single = arrange(once, grid);
  const Arrangement both = arrange(twice, grid);
  ASSERT_NO_FATAL_FAILURE(expect_clean(both));
  for (int c = 0; c < grid.sectors; ++c) {
    ASSERT_EQ(both.sectors[c].size(), single.sectors[c].size());
    for (std::size_t i = 0; i < both.sectors[c].size(); ++i) {
      EXPECT_EQ(both.sectors[c][i].a, single.sectors[c][i].a);
      EXPECT_EQ(both.sectors[c][i].b, single.sectors[c][i].b);
      EXPECT_EQ(both.sectors[c][i].winding, 2 * single.sectors[c][i].winding);
    }
  }
}

TEST(Arrangement, OfStripsThatGrazeOverTheirWholeLength) {
  // A fan of slivers through one point, each a single step wider at its end than the one before.
  std::vector<std::vector<GridPoint>> fan;
  for (std::int32_t k = 1; k <= 40; ++k)
    fan.push_back({{100, 500}, {900, 500 - k}, {900, 500 + k}});
  ASSERT_NO_FATAL_FAILURE(expect_clean(arrange(on_square_grid(fan), square_grid())));
  // Strips one step wide that cross at less than a step's slope, over the seam.
  std::vector<std::vector<GridPoint>> weave;
  for (std::int32_t k = 0; k < 12; ++k) {
    weave.push_back({{-900, 300 + k}, {900, 311 - k}, {900, 312 - k}, {-900, 301 + k}});
  }
  ASSERT_NO_FATAL_FAILURE(expect_clean(arrange(on_square_grid(weave), square_grid())));
}

TEST(Arrangement, DoesNotDragEdgesAlongTheGrid) {
  // Sides of three families meet here at small angles, one of them twice in opposite directions;
  // cut at their crossings alone, they overtake each other and run along a grid line for ever.
  Segment segment;
  segment.length_mm = 7.307548411;
  segment.liner = {6.137441919, 0.8644721058, {}};
  segment.lattice = Lattice{0.4163570575, {}, std::nullopt, {}};
  segment.lattice->grids = {
      {158.7191464,
       {0.2094638263, 0.1829696521, 0.2082820219, 0.2121217581, 0.2093805657, 0.2227162502,
        0.1692357028, 0.1910986322, 0.1822880899, 0.1789425578, 0.182672458},
       StraightPath{}},
      {168.940829, std::vector<double>(7, 1.241418486), StraightPath{}},
      {56.10407753, std::vector<double>(4, 4.085531037), StraightPath{}}};
  const Pattern pattern = draw_lattice(segment, 0.005);
  const PlaneGrid grid = make_plane_grid(pattern.circumference_mm, pattern.length_mm,
                                         sectors_for(segment.outer_radius_mm(), 0.007415178236));
  const Arrangement arranged = arrange(pattern, grid);
  ASSERT_NO_FATAL_FAILURE(expect_clean(arranged));
  EXPECT_LT(farthest_from_outlines(arranged, pattern), 4);
}

TEST(Arrangement, OfTenThousandCrossingsOnATinyGrid) {
  // Far more crossings than grid points: nothing is left but the grid.
  RandomNumbers random(11);
  std::vector<std::vector<GridPoint>> needles;
  for (int i = 0; i < 100; ++i) {
    const auto corner = [&] { return GridPoint{random.whole(1030, 1060), random.whole(10, 40)}; };
    needles.push_back({corner(), corner(), corner()});
  }
  ASSERT_NO_FATAL_FAILURE(expect_clean(arrange(on_square_grid(needles), square_grid())));
}

TEST(Arrangement, RefusesTooManyPiecesBeforeMakingThem) {
  const PlaneGrid grid = make_plane_grid(100, 1e5, 20000);
  const double around = 100.0 * 1001;
  Pattern pattern{100, 1e5, {}};
  pattern.strands.push_back({{{0, 0}, {0.1, 0}, {around + 0.1, 1e5}, {around, 1e5}}});
  EXPECT_THROW(arrange(pattern, grid), GeometryError);
}

TEST(Arrangement, CountsTheCutsOfEveryStrandBeforeMakingThem) {
  Pattern pattern{100, 80, {}};
  for (int i = 0; i < 3000; ++i) {
    const double u = i / 30.0;
    pattern.strands.push_back({{{u, 0}, {u + 0.01, 0}, {u + 0.01, 80}, {u, 80}}});
  }
  const PlaneGrid grid = make_plane_grid(100, 80, 12);
  std::vector<std::int32_t> cuts;
  for (std::int32_t z = 100; z < grid.length_steps; z += 100) cuts.push_back(z);
  EXPECT_THROW(arrange(pattern, grid, cuts), GeometryError);
}

TEST(Arrangement, RefusalsSayWhatToChange) {
  Pattern pattern{100, 80, {}};
  pattern.strands.push_back({{{0, 0}, {1, 0}, {1e12, 80}, {1e12 - 1, 80}}});
  try {
    arrange(pattern, make_plane_grid(100, 80, 12));
    FAIL() << "an outline ten thousand million turns long was arranged";
  } catch (const GeometryError& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("fewer strands"), std::string::npos);
  }
}

}  // namespace
}  // namespace latticast
