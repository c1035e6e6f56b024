// SPDX-License-Identifier: GPL-3.0-or-later
// One period of the plane: exact areas, alike sides, a closed surface, and the drawing's own area.
#include "geometry/solid/period_mesh.h"

#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/solid/lattice_drawing.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// A lattice and the piece of it that repeats.
struct Case {
  std::string name;
  Segment segment;
  double from_mm = 0;
  double to_mm = 0;
  int sectors = 3;  // of the grid
  int taken = 1;    // of them in the period
  double shift_mm = 0;
  bool mirrored = false;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

Segment with_rings(Segment segment, double pitch_mm, double phase) {
  segment.lattice->rings =
      Rings{.count = std::nullopt, .pitch_mm = pitch_mm, .width_mm = 2, .phase = phase};
  return segment;
}

std::vector<Case> cases() {
  constexpr double wave = 85.0 / 8;
  const Segment even = columns(std::vector<double>(16, 2.0));
  const Segment halved = columns(halves(16, 3, 2));
  Segment sinusoids = even;
  sinusoids.lattice->grids[0].path = Sinusoid{1.2, 8};
  const double around = even.lattice_circumference_mm();
  const double turn = 10 / std::tan(36 * degree);
  // Opposite families that repeat after one pitch.
  Segment pair = paper_segment({60, 120});
  const double pitch = std::tan(60 * degree) * around / 16;
  pair.length_mm = 6 * pitch;
  return {
      {"bulges", with_rings(even, wave, 0.25), 1.25 * wave, 1.75 * wave, 16, 1, 0, true},
      {"junctions", with_rings(even, wave, 0.5), 1.5 * wave, 2.5 * wave, 16, 1, 0, false},
      {"quarters", with_rings(even, wave, 0.4), 1.4 * wave, 2.4 * wave, 16, 1, 0, false},
      {"all_around", with_rings(halved, wave, 0.25), 1.25 * wave, 1.75 * wave, 16, 16, 0, true},
      {"strips", twisting_segment(36), 15, 25, 8, 1, turn, false},
      {"sinusoids", with_rings(sinusoids, wave, 0.25), 1.25 * wave, 1.75 * wave, 16, 1, 0, true},
      {"opposite", with_rings(pair, pitch, 0.5), 1.5 * pitch, 2.5 * pitch, 8, 1,
       pitch / std::tan(60 * degree), false},
  };
}

Region region_of(const Case& c, Period& period) {
  const PlaneGrid grid =
      make_plane_grid(c.segment.lattice_circumference_mm(), c.segment.length_mm, c.sectors);
  period = {.sectors = c.taken,
            .z_from = static_cast<std::int32_t>(std::lround(c.from_mm / grid.z_step_mm)),
            .z_to = static_cast<std::int32_t>(std::lround(c.to_mm / grid.z_step_mm)),
            .shift_mm = c.shift_mm,
            .mirrored = c.mirrored};
  LatticeDrawing drawing(c.segment);
  const std::array cuts = {period.z_from, period.z_to};
  return drawing.united(1e-3, grid, cuts, 0.02);
}

/// Of a quadratic triangle: that of its corners, and 2/3 of the parabolas on its sides.
double area_mm2(const PeriodMesh& mesh, const PeriodMesh::Triangle& triangle) {
  std::array<PlanePoint, 6> p;
  for (std::size_t i = 0; i < 6; ++i) p[i] = mesh.nodes[triangle.nodes[i]].at;
  double area = 0.5 * cross(p[0], p[1], p[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    area += 2.0 / 3 * cross(p[i], p[3 + i], p[(i + 1) % 3]);
  }
  return area;
}

class PeriodMeshes : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    region_ = region_of(GetParam(), period_);
    mesh_ = triangulate_period(region_, period_, {.size_mm = 2, .most_turn_rad = pi / 6});
  }
  Region region_;
  Period period_;
  PeriodMesh mesh_;
};

TEST_P(PeriodMeshes, CoverTheirBoxOnce) {
  double area = 0;
  for (const auto& triangle : mesh_.triangles) {
    const double part = area_mm2(mesh_, triangle);
    EXPECT_GT(part, 0);
    area += part;
  }
  const PeriodBox& box = mesh_.box;
  EXPECT_NEAR(area, box.width_mm * (box.z_to_mm - box.z_from_mm), 1e-9 * area);
}

TEST_P(PeriodMeshes, AreMaterialWhereTheDrawingIs) {
  double area = 0;
  for (const auto& triangle : mesh_.triangles) {
    if (triangle.layers != 0) area += area_mm2(mesh_, triangle);
  }
  // The same piece, drawn with fine chords and without curves, from the region itself.
  Period whole = period_;
  const PeriodMesh fine =
      triangulate_period(region_, whole, {.size_mm = 0.5, .most_turn_rad = pi / 40});
  double expected = 0;
  for (const auto& triangle : fine.triangles) {
    if (triangle.layers == 0) continue;
    expected += 0.5 * cross(fine.nodes[triangle.nodes[0]].at, fine.nodes[triangle.nodes[1]].at,
                            fine.nodes[triangle.nodes[2]].at);
  }
  EXPECT_NEAR(area, expected, 1.5e-3 * expected);
  EXPECT_LT(area, 0.95 * mesh_.box.width_mm * (mesh_.box.z_to_mm - mesh_.box.z_from_mm));
}

TEST_P(PeriodMeshes, RepeatNodeForNode) {
  const PeriodBox& box = mesh_.box;
  int tied = 0;
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
    const PlanePoint here = mesh_.nodes[i].at;
    const PlanePoint there = mesh_.nodes[mesh_.nodes[i].image].at;
    if (mesh_.nodes[i].image == i) continue;
    ++tied;
    // A whole number of widths, and of shifts along the tube.
    const double pitches = (here.z - there.z) / (box.z_to_mm - box.z_from_mm);
    EXPECT_NEAR(pitches, std::round(pitches), 1e-7);
    const double widths =
        (here.u - there.u - std::round(pitches) * period_.shift_mm) / box.width_mm;
    EXPECT_NEAR(widths, std::round(widths), 1e-6);
  }
  EXPECT_GT(tied, 0);
}

TEST_P(PeriodMeshes, CloseIntoATorusOrABand) {
  // Vertices - edges + triangles = 0 once the images are one, middles standing for the edges.
  std::set<std::uint32_t> corners;
  std::set<std::uint32_t> middles;
  for (const auto& triangle : mesh_.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners.insert(mesh_.nodes[triangle.nodes[i]].image);
      middles.insert(mesh_.nodes[triangle.nodes[3 + i]].image);
    }
  }
  EXPECT_EQ(static_cast<int>(corners.size()) - static_cast<int>(middles.size()) +
                static_cast<int>(mesh_.triangles.size()),
            0);
}

TEST_P(PeriodMeshes, ShareTheirSides) {
  // Every inner side has one triangle on each of its sides.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> owners;
  for (const auto& triangle : mesh_.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++owners[{triangle.nodes[i], triangle.nodes[(i + 1) % 3]}];
    }
  }
  const auto is_on_frame = [&](PlanePoint p) {
    return std::abs(p.u) < 1e-6 || std::abs(p.u - mesh_.box.width_mm) < 1e-6 ||
           std::abs(p.z - mesh_.box.z_from_mm) < 1e-6 || std::abs(p.z - mesh_.box.z_to_mm) < 1e-6;
  };
  for (const auto& [side, count] : owners) {
    EXPECT_EQ(count, 1);
    if (owners.contains({side.second, side.first})) continue;
    EXPECT_TRUE(is_on_frame(mesh_.nodes[side.first].at));
    EXPECT_TRUE(is_on_frame(mesh_.nodes[side.second].at));
  }
}

INSTANTIATE_TEST_SUITE_P(Lattices, PeriodMeshes, ::testing::ValuesIn(cases()),
                         [](const auto& at) { return at.param.name; });

}  // namespace
}  // namespace latticast::testing
