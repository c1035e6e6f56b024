// SPDX-License-Identifier: GPL-3.0-or-later
// What every flat pattern promises, counted another way: from the triangles of the union, and from
// all pairs of edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/flat_pattern.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/plane_mesh.h"
#include "geometry/solid/region.h"

namespace latticast {

/// A point in whole grid steps.
struct StepPoint {
  std::int64_t u, z;
  friend auto operator<=>(const StepPoint&, const StepPoint&) = default;
};
using StepEdge = std::pair<StepPoint, StepPoint>;

inline PlaneGrid grid_of(const FlatPattern& sheet) {
  return make_plane_grid(sheet.circumference_mm, sheet.length_mm, 4);
}

/// Every point of the sheet, in steps; each must be a whole number of them.
inline std::vector<std::vector<StepPoint>> loops_in_steps(const FlatPattern& sheet) {
  const PlaneGrid grid = grid_of(sheet);
  std::vector<std::vector<StepPoint>> loops;
  const auto add = [&](const std::vector<PlanePoint>& loop) {
    loops.emplace_back();
    for (const PlanePoint& p : loop) {
      loops.back().push_back(
          {std::llround(p.u / grid.u_step_mm), std::llround(p.z / grid.z_step_mm)});
      EXPECT_EQ(static_cast<double>(loops.back().back().u) * grid.u_step_mm, p.u);
      EXPECT_NEAR(static_cast<double>(loops.back().back().z) * grid.z_step_mm, p.z, 1e-13 * p.z);
      EXPECT_GE(p.u, 0);
      EXPECT_LE(p.u, sheet.circumference_mm);
      EXPECT_GE(p.z, 0);
      EXPECT_LE(p.z, sheet.length_mm);
    }
  };
  for (const FlatPiece& piece : sheet.pieces) {
    add(piece.outer);
    for (const auto& hole : piece.holes) add(hole);
  }
  return loops;
}

inline double area_in_steps(const std::vector<StepPoint>& loop) {
  std::int64_t twice = 0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    twice += (loop[j].u - loop[0].u) * (loop[i].z - loop[0].z) -
             (loop[i].u - loop[0].u) * (loop[j].z - loop[0].z);
  }
  return 0.5 * static_cast<double>(twice);
}

inline int side_of(const StepEdge& edge, StepPoint p) {
  const std::int64_t turn = (edge.second.u - edge.first.u) * (p.z - edge.first.z) -
                            (edge.second.z - edge.first.z) * (p.u - edge.first.u);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

inline bool meet(const StepEdge& e, const StepEdge& f) {
  const auto apart = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  if (apart(e.first.u, e.second.u, f.first.u, f.second.u)) return false;
  if (apart(e.first.z, e.second.z, f.first.z, f.second.z)) return false;
  return side_of(e, f.first) * side_of(e, f.second) <= 0 &&
         side_of(f, e.first) * side_of(f, e.second) <= 0;
}

/// No point twice, no two edges meet but neighbours in their common end; orientation by kind.
inline void expect_simple(const FlatPattern& sheet) {
  const auto loops = loops_in_steps(sheet);
  std::set<StepPoint> points;
  std::size_t count = 0;
  std::vector<StepEdge> edges;
  for (const auto& loop : loops) {
    ASSERT_GE(loop.size(), 3U);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      points.insert(loop[i]);
      ++count;
      const StepPoint next = loop[(i + 1) % loop.size()];
      edges.push_back({std::min(loop[i], next), std::max(loop[i], next)});
    }
  }
  ASSERT_EQ(points.size(), count) << "a point occurs twice";
  std::sort(edges.begin(), edges.end());
  std::vector<StepEdge> open;  // those that the sweep has not passed
  std::size_t crossings = 0;
  for (const StepEdge& edge : edges) {
    std::erase_if(open, [&](const StepEdge& e) { return e.second.u < edge.first.u; });
    for (const StepEdge& other : open) {
      const bool neighbours = edge.first == other.first || edge.first == other.second ||
                              edge.second == other.first || edge.second == other.second;
      if (!neighbours && meet(edge, other)) ++crossings;
    }
    open.push_back(edge);
  }
  EXPECT_EQ(crossings, 0U);
  std::size_t loop = 0;
  for (const FlatPiece& piece : sheet.pieces) {
    EXPECT_GT(area_in_steps(loops[loop++]), 0);
    for (std::size_t hole = 0; hole < piece.holes.size(); ++hole) {
      EXPECT_LT(area_in_steps(loops[loop++]), 0);
    }
  }
}

/// Pieces and holes of a sheet slit at u = 0.
struct SheetTopology {
  int pieces = 0;
  int holes = 0;
};

/// From the triangles, which are glued along all edges but those on the slit: V - E + F = pieces -
/// holes.
inline SheetTopology triangle_topology(const PlaneMesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  DisjointSets connected(2 * n);
  std::set<std::uint32_t> corners;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : mesh.triangles) {
    const bool last = std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return mesh.vertices[v].sector == mesh.grid.sectors - 1;
    });
    std::array<std::uint32_t, 3> corner{};
    for (int i = 0; i < 3; ++i) {
      const bool on_slit = mesh.vertices[t[i]].sector == 0 && mesh.vertices[t[i]].point.u == 0;
      corner[i] = last && on_slit ? n + t[i] : t[i];
      corners.insert(corner[i]);
    }
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t next = corner[(i + 1) % 3];
      sides.insert({std::min(corner[i], next), std::max(corner[i], next)});
      connected.join(corner[i], next);
    }
  }
  SheetTopology counted;
  for (const std::uint32_t v : corners) counted.pieces += connected.root(v) == v;
  counted.holes = counted.pieces - static_cast<int>(corners.size()) +
                  static_cast<int>(sides.size()) - static_cast<int>(mesh.triangles.size());
  return counted;
}

/// The union as `flat_pattern` draws it, before it is slit.
inline Region flat_region(const Segment& segment, const FlatPattern& sheet, double tolerance_mm) {
  const Lattice& lattice = *segment.lattice;
  const bool arcs = std::any_of(lattice.grids.begin(), lattice.grids.end(),
                                [](const Grid& grid) { return is_curved(grid.path); });
  const double share = lattice.fillet_mm == 0 ? 0.95 : arcs ? 0.44 : 0.88;
  const double flatness = share * tolerance_mm;
  // What it closes and parts is tested by itself (slivers_test).
  LatticeDrawing drawing(segment, tolerance_mm);
  return drawing.united(flatness, grid_of(sheet), {}, tolerance_mm);
}

/// What the two sides of the slit have in material, as z intervals, the way the sheet's outlines
/// run there.
inline std::vector<std::pair<double, double>> slit_side(const FlatPattern& sheet, double u) {
  std::vector<std::pair<double, double>> stretches;
  for (const FlatPiece& piece : sheet.pieces) {
    std::vector<std::vector<PlanePoint>> loops = piece.holes;
    loops.push_back(piece.outer);
    for (const auto& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PlanePoint& a = loop[i];
        const PlanePoint& b = loop[(i + 1) % loop.size()];
        if (a.u == u && b.u == u) stretches.emplace_back(std::min(a.z, b.z), std::max(a.z, b.z));
      }
    }
  }
  std::sort(stretches.begin(), stretches.end());
  return stretches;
}

/// Openings whose tips the slit goes through.
inline int tips_on_slit(const Region& region) {
  int tips = 0;
  bool below = false;
  for (const LinePoint& point : line_points(region, 0)) {
    const bool above = point.inside_before != 0 && point.inside_after != 0;
    tips += below && above;
    below = above;
  }
  return tips;
}

/// All that flat_pattern.h promises. Where the slit goes through an opening's tip, the diamond
/// there may open or close what is about as small: then only simplicity and area are looked at.
inline void expect_sound_sheet(const Segment& segment, const FlatPattern& sheet,
                               double tolerance_mm) {
  ASSERT_NO_FATAL_FAILURE(expect_simple(sheet));
  const Region region = flat_region(segment, sheet, tolerance_mm);
  const int tips = tips_on_slit(region);
  const double step_area = region.grid.u_step_mm * region.grid.z_step_mm;
  double area = 0;
  for (const auto& loop : loops_in_steps(sheet)) area += area_in_steps(loop);
  EXPECT_NEAR(area * step_area, sheet.area_mm2, 1e-14 * sheet.area_mm2);
  EXPECT_NEAR(sheet.area_mm2, area_mm2(region),
              1e-14 * area_mm2(region) + (tips > 0 ? sheet.error.area_mm2 : 0));
  if (tips > 0) return;
  const SheetTopology counted = triangle_topology(triangulate(region));
  ASSERT_EQ(static_cast<int>(sheet.pieces.size()), counted.pieces);
  int holes = 0;
  for (const FlatPiece& piece : sheet.pieces) holes += static_cast<int>(piece.holes.size());
  EXPECT_EQ(holes, counted.holes);
  // Where both sides of the slit have material they have it between the same heights.
  const auto left = slit_side(sheet, 0);
  const auto right = slit_side(sheet, sheet.circumference_mm);
  std::vector<std::pair<double, double>> both;
  std::set_intersection(left.begin(), left.end(), right.begin(), right.end(),
                        std::back_inserter(both));
  double common = 0;
  for (const auto& [low, high] : both) common += high - low;
  double joined = 0;
  const std::vector<LinePoint> points = line_points(region, 0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].inside_before == 0 || points[i].inside_after == 0) continue;
    joined += (points[i + 1].z - points[i].z) * region.grid.z_step_mm;
  }
  EXPECT_NEAR(common, joined, 1e-9 * sheet.length_mm);
}

}  // namespace latticast
