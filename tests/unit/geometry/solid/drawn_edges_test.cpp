// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/drawn_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "geometry/pattern/cannot_draw.h"
#include "geometry/solid/fillet.h"
#include "geometry/solid/plane_mesh.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

constexpr double flatness_mm = 0.005;
constexpr double closing_mm = 1e-4;
constexpr double most_steps = 4;  // that snapping moves an edge by (arrangement_test)

// Horseshoe families that close on the segment and do not touch themselves, with or without rings.
Segment horseshoe_segment(RandomNumbers& random) {
  Segment segment;
  segment.length_mm = random.between(20, 60);
  segment.liner = {random.between(6, 15), 1, {}};
  segment.lattice = Lattice{random.between(0.5, 3), {}, std::nullopt, {}};
  const int count = random.whole(2, 6);
  const int links = 2 * random.whole(2, 6);
  const double arc = random.between(60, 200);
  const bool alternate = arc > 180 || random.whole(0, 1) == 0;
  const double angle = random.whole(0, 1) == 0 ? 90 : random.between(50, 130);
  const double chord = segment.length_mm / (links * std::sin(angle * std::numbers::pi / 180));
  const double radius = 0.5 * chord / std::sin(0.5 * arc * std::numbers::pi / 180);
  const double width = random.between(0.1, 0.3) * radius;
  segment.lattice->grids.push_back(
      {angle, std::vector<double>(count, width), Horseshoe{radius, arc, alternate}});
  if (random.whole(0, 1) == 0) segment.lattice->rings = Rings{3, std::nullopt, 1.5};
  return segment;
}

// An edge of the united plane in mm, u counted from the seam.
struct PlaneEdge {
  PlanePoint a;
  PlanePoint b;
  EdgeOrigin origin = on_sector_line;
};

PlanePoint in_mm(const PlaneGrid& grid, int sector, GridPoint p) {
  return {(static_cast<double>(sector) * grid.sector_steps + p.u) * grid.u_step_mm,
          p.z * grid.z_step_mm};
}

// The region's outline, and what it holds of sector lines and of cuts.
std::vector<PlaneEdge> outline_of(const Region& region) {
  std::vector<PlaneEdge> edges;
  for (int c = 0; c < region.grid.sectors; ++c) {
    for (const RegionEdge& edge : region.sectors[c]) {
      if (!edge.is_outline()) continue;
      edges.push_back({in_mm(region.grid, c, edge.a), in_mm(region.grid, c, edge.b), edge.origin});
    }
    const std::vector<LinePoint> points = line_points(region, c);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (points[i].inside_before == points[i].inside_after) continue;
      edges.push_back({in_mm(region.grid, c, {0, points[i].z}),
                       in_mm(region.grid, c, {0, points[i + 1].z}),
                       origin_on_line(region, c, points[i].z, points[i + 1].z)});
    }
  }
  return edges;
}

std::vector<PlaneEdge> outline_of(const PlaneMesh& mesh) {
  std::vector<PlaneEdge> edges;
  for (const OutlineEdge& edge : mesh.outline) {
    const PlaneMeshVertex& from = mesh.vertices[edge.from];
    const PlaneMeshVertex& to = mesh.vertices[edge.to];
    PlanePoint a = in_mm(mesh.grid, from.sector, from.point);
    PlanePoint b = in_mm(mesh.grid, to.sector, to.point);
    const double around = mesh.drawn.circumference_mm;
    b.u += around * std::round((a.u - b.u) / around);
    edges.push_back({a, b, edge.origin});
  }
  return edges;
}

double step_mm(const PlaneGrid& grid) {
  return std::hypot(grid.u_step_mm, grid.z_step_mm);
}

// Both ends and the middle of each edge lie where the curve is at the piece's ends and middle.
void expect_on_curves(const std::vector<PlaneEdge>& edges, const DrawnEdges& drawn,
                      const PlaneGrid& grid, const DrawingError& error) {
  const double allowed = most_steps * step_mm(grid) + 1.5 * error.distance_mm;
  for (const PlaneEdge& edge : edges) {
    const auto piece = traced(drawn, edge.origin, edge.a, edge.b);
    if (!piece) {
      ASSERT_TRUE(edge.origin == on_segment_start || edge.origin == on_segment_end)
          << edge.origin << " at " << edge.a.u << ", " << edge.a.z;
      const double level = edge.origin == on_segment_start ? 0 : grid.length_steps * grid.z_step_mm;
      ASSERT_NEAR(edge.a.z, level, most_steps * grid.z_step_mm);
      ASSERT_NEAR(edge.b.z, level, most_steps * grid.z_step_mm);
      continue;
    }
    for (const double part : {0.0, 0.5, 1.0}) {
      const PlanePoint on_edge{std::lerp(edge.a.u, edge.b.u, part),
                               std::lerp(edge.a.z, edge.b.z, part)};
      PlanePoint on_curve = point_at(piece->curve.shape, std::lerp(piece->from, piece->to, part));
      on_curve.u += piece->turns * drawn.circumference_mm;
      ASSERT_LT(distance(on_edge, on_curve), allowed)
          << "edge at " << on_edge.u << ", " << on_edge.z << " of curve at " << on_curve.u << ", "
          << on_curve.z << ", origin " << edge.origin;
    }
  }
}

bool is_inside(const Pattern& pattern, PlanePoint p) {
  for (const Strand& strand : pattern.strands) {
    int winding = 0;
    const auto& outline = strand.outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PlanePoint& a = outline[i];
      const PlanePoint& b = outline[(i + 1) % outline.size()];
      if ((a.z <= p.z) == (b.z <= p.z)) continue;
      const double u = std::lerp(a.u, b.u, (p.z - a.z) / (b.z - a.z));
      // Copies of the crossing to the right of p, less a common number of them.
      const auto copies = static_cast<int>(std::floor((u - p.u) / pattern.circumference_mm));
      winding += b.z > a.z ? copies : -copies;
    }
    if (winding > 0) return true;
  }
  return false;
}

double distance_to_edge(PlanePoint p, PlanePoint a, PlanePoint b) {
  const double du = b.u - a.u;
  const double dz = b.z - a.z;
  const double part = ((p.u - a.u) * du + (p.z - a.z) * dz) / (du * du + dz * dz);
  const double inside = std::clamp(part, 0.0, 1.0);
  return std::hypot(a.u + inside * du - p.u, a.z + inside * dz - p.z);
}

// Wherever on the tube: an edge may wind around it.
double distance_around(PlanePoint p, PlanePoint a, PlanePoint b, double around) {
  const auto [low, high] = std::minmax(a.u, b.u);
  double nearest = HUGE_VAL;
  for (double turn = std::floor((low - p.u) / around); turn * around + p.u < high + around;
       ++turn) {
    nearest = std::min(nearest, distance_to_edge({p.u + turn * around, p.z}, a, b));
  }
  return nearest;
}

// A place on a drawn edge.
struct Probe {
  EdgeOrigin edge = 0;
  PlanePoint place;
};

bool is_alone(const DrawnEdges& drawn, const Probe& probe, double margin) {
  for (EdgeOrigin i = 0; i < drawn.edges.size(); ++i) {
    const DrawnEdge& edge = drawn.edges[i];
    if (i == probe.edge || distance(edge.from, edge.to) == 0) continue;
    if (std::min(edge.from.z, edge.to.z) > probe.place.z + margin) continue;
    if (std::max(edge.from.z, edge.to.z) < probe.place.z - margin) continue;
    if (distance_around(probe.place, edge.from, edge.to, drawn.circumference_mm) < margin) {
      return false;
    }
  }
  return true;
}

// Places where a drawn edge borders the union, with no other edge nearer than `margin`.
std::vector<Probe> bordering(const Pattern& closed, const DrawnEdges& drawn, double margin) {
  std::vector<Probe> probes;
  for (EdgeOrigin i = 0; i < drawn.edges.size(); ++i) {
    const auto& [from, to, range] = drawn.edges[i];
    const double length = distance(from, to);
    if (length < 10 * margin) continue;
    const PlanePoint outwards{(to.z - from.z) / length, (from.u - to.u) / length};
    for (const double part : {0.2, 0.5, 0.83}) {
      const PlanePoint p{std::lerp(from.u, to.u, part), std::lerp(from.z, to.z, part)};
      if (p.z < 2 * margin || p.z > closed.length_mm - 2 * margin) continue;
      const double half = 0.5 * margin;
      if (is_inside(closed, {p.u + half * outwards.u, p.z + half * outwards.z})) continue;
      if (is_alone(drawn, {i, p}, margin)) probes.push_back({i, p});
    }
  }
  return probes;
}

// An outline edge runs there and says that it comes from there.
void expect_found(const Probe& probe, const std::vector<PlaneEdge>& outline, double around,
                  double allowed) {
  const auto runs_there = [&](const PlaneEdge& edge) {
    PlanePoint p = probe.place;
    p.u += around * std::round((edge.a.u - p.u) / around);
    return edge.origin == probe.edge && distance_to_edge(p, edge.a, edge.b) < allowed;
  };
  EXPECT_TRUE(std::any_of(outline.begin(), outline.end(), runs_there))
      << "drawn edge " << probe.edge << " at " << probe.place.u << ", " << probe.place.z;
}

double length_mm(const TracedCurve& piece) {
  constexpr int steps = 16;
  double length = 0;
  for (int i = 0; i < steps; ++i) {
    const double from = std::lerp(piece.from, piece.to, static_cast<double>(i) / steps);
    const double to = std::lerp(piece.from, piece.to, static_cast<double>(i + 1) / steps);
    length += distance(point_at(piece.curve.shape, from), point_at(piece.curve.shape, to));
  }
  return length;
}

// The outline is as long as the pieces of curves that it stands for.
void expect_lengths(const std::vector<PlaneEdge>& outline, const DrawnEdges& drawn,
                    double allowed_per_edge) {
  double along_edges = 0;
  double along_curves = 0;
  for (const PlaneEdge& edge : outline) {
    const auto piece = traced(drawn, edge.origin, edge.a, edge.b);
    if (!piece) continue;
    along_edges += distance(edge.a, edge.b);
    along_curves += length_mm(*piece);
  }
  EXPECT_NEAR(along_edges, along_curves, allowed_per_edge * static_cast<double>(outline.size()));
}

// Counts the places that were tried.
void expect_provenance(const Pattern& pattern, const PlaneGrid& grid,
                       std::span<const std::int32_t> cuts, std::size_t& probes_tried) {
  const Region region = unite(pattern, grid, cuts, closing_mm);
  const std::vector<PlaneEdge> outline = outline_of(region);
  ASSERT_NO_FATAL_FAILURE(expect_on_curves(outline, region.drawn, grid, region.error));
  const PlaneMesh mesh = triangulate(region);
  ASSERT_NO_FATAL_FAILURE(expect_on_curves(outline_of(mesh), mesh.drawn, grid, region.error));
  const double snapped = most_steps * step_mm(grid);
  expect_lengths(outline, region.drawn, snapped + 0.1 * region.error.distance_mm);
  // Diamonds are drawn edges too.
  const Pattern closed = closed_pattern(pattern, grid, closing_mm);
  const auto probes = bordering(closed, region.drawn, 4 * snapped);
  for (const Probe& probe : probes) {
    expect_found(probe, outline, pattern.circumference_mm, snapped);
  }
  probes_tried += probes.size();
}

TEST(DrawnEdges, OfRandomPatternsAreWhereTheyCameFrom) {
  constexpr std::uint64_t seed = 11001;
  std::size_t probes = 0;
  for (std::uint64_t i = 0; i < 120 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    std::vector<std::int32_t> cuts;
    if (i % 2 == 0) cuts = {plane.grid.length_steps / 3, plane.grid.length_steps / 2};
    expect_provenance(plane.pattern, plane.grid, cuts, probes);
  }
  EXPECT_GE(probes, 2000U);
  std::printf("seeds from %llu: %zu places on drawn edges found\n",
              static_cast<unsigned long long>(seed), probes);
}

TEST(DrawnEdges, OfHorseshoesAreTheirArcs) {
  constexpr std::uint64_t seed = 11501;
  int drawn = 0;
  std::size_t probes = 0;
  for (std::uint64_t i = 0; i < 16 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Segment segment = horseshoe_segment(random);
    try {
      const Pattern pattern = draw_lattice(segment, flatness_mm);
      expect_provenance(
          pattern,
          make_plane_grid(pattern.circumference_mm, pattern.length_mm, random.whole(12, 40)), {},
          probes);
      ++drawn;
    } catch (const CannotDraw&) {
    }
  }
  EXPECT_GE(drawn, 8);
  std::printf("seeds from %llu: %d of 16 drawn, %zu places found\n",
              static_cast<unsigned long long>(seed), drawn, probes);
}

struct Shares {
  std::size_t edges = 0;
  std::size_t of_strands = 0;
  std::size_t of_fillets = 0;
};

void count_parts(const Region& region, Shares& shares) {
  for (const PlaneEdge& edge : outline_of(region)) {
    const auto piece = traced(region.drawn, edge.origin, edge.a, edge.b);
    if (!piece) continue;
    ++shares.edges;
    const CurvePart part = piece->curve.part;
    if (part == CurvePart::fillet) {
      ++shares.of_fillets;
    } else if (part != CurvePart::other) {
      ++shares.of_strands;
    }
  }
}

TEST(DrawnEdges, OfFilletsAreArcsBetweenTheStrands) {
  constexpr std::uint64_t seed = 11801;
  Shares shares;
  for (std::uint64_t i = 0; i < 24 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Segment segment = i % 2 == 0 ? horseshoe_segment(random) : random_segment(random);
    const double radius = random.log_between(0.1, 1);
    const Pattern pattern =
        with_fillets(draw_lattice(segment, 0.5 * flatness_mm), radius, 0.5 * flatness_mm);
    const PlaneGrid grid =
        make_plane_grid(pattern.circumference_mm, pattern.length_mm, random.whole(12, 40));
    const Region region = unite(pattern, grid, {}, closing_mm);
    const auto outline = outline_of(region);
    ASSERT_NO_FATAL_FAILURE(expect_on_curves(outline, region.drawn, grid, region.error));
    expect_lengths(outline, region.drawn, most_steps * step_mm(grid) + region.error.distance_mm);
    count_parts(region, shares);
  }
  std::printf("seeds from %llu: %zu edges, %zu of strands and rings, %zu of fillets\n",
              static_cast<unsigned long long>(seed), shares.edges, shares.of_strands,
              shares.of_fillets);
  EXPECT_GT(shares.of_fillets, shares.edges / 10);
  // Chords on either side of an inflection lie in line and have become one, which is neither's.
  EXPECT_GT(shares.of_fillets + shares.of_strands, shares.edges - shares.edges / 40);
}

}  // namespace
}  // namespace latticast
