// SPDX-License-Identifier: GPL-3.0-or-later
// Reliefs of several layers: grooves, bores and steps, and rods that reach the axis.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "geometry/solid/arrangement.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/region.h"
#include "geometry/solid/relief.h"
#include "tests/unit/geometry/solid/mesh_measures.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

constexpr unsigned lattice_sheet = 1;
constexpr unsigned piece_sheet = 2;
constexpr unsigned bore_sheet = 4;

Strand rectangle(double u_from, double u_to, double z_from, double z_to) {
  return {{{u_from, z_from}, {u_to, z_from}, {u_to, z_to}, {u_from, z_to}}};
}

Strand disc(double u, double z, double radius) {
  Strand strand;
  for (int i = 0; i < 20; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.3) / 20;
    strand.outline.push_back({u + radius * std::cos(turn), z + radius * std::sin(turn)});
  }
  return strand;
}

// A grooved piece of a shell: its floor is missing over the lattice, everything over the bores.
Layers grooved(unsigned sheets) {
  if ((sheets & piece_sheet) == 0) return 0;
  const Layers floor = (sheets & lattice_sheet) != 0 ? 0U : 1U;
  const Layers shell = (sheets & bore_sheet) != 0 ? 0U : 2U;
  return floor | shell;
}

double share(double inner, double outer, double circumference) {
  return (outer * outer - inner * inner) * std::numbers::pi / circumference;
}

TEST(Layers, WindingsOfSheetsDoNotMix) {
  const std::int64_t sum =
      3 * winding_on(0) - 7 * winding_on(1) + 250 * winding_on(2) - winding_on(3);
  EXPECT_EQ(winding_of_sheet(sum, 0), 3);
  EXPECT_EQ(winding_of_sheet(sum, 1), -7);
  EXPECT_EQ(winding_of_sheet(sum, 2), 250);
  EXPECT_EQ(winding_of_sheet(sum, 3), -1);
  EXPECT_EQ(winding_of_sheet(sum + winding_on(3) - 3 * winding_on(0), 0), 0);
}

TEST(Layers, OfRandomGroovedShellsAreClosedWithTheirTopologyAndVolume) {
  constexpr std::uint64_t seed = 7400;
  double most_genus = 0;
  int made = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const RandomPlane plane = random_plane(seed + i);
    const double around = plane.pattern.circumference_mm;
    const double length = plane.pattern.length_mm;
    const double middle = around / (2 * std::numbers::pi);
    Pattern piece{around, length, {rectangle(0.13 * around, 0.61 * around, 0, length)}};
    Pattern bores{around,
                  length,
                  {disc(0.3 * around, 0.4 * length, 0.03 * around),
                   disc(0.52 * around, 0.45 * length, 0.01 * around)}};
    const Pattern sheets[] = {closed_pattern(plane.pattern, plane.grid, 0.01), piece, bores};
    Region region;
    try {
      region = layered_region(sheets, plane.grid, {}, grooved);
    } catch (const GeometryError&) {
      continue;  // an edge of the piece meets a corner of the lattice
    }
    ++made;
    const std::vector<std::vector<double>> radii = {{0.9 * middle, middle},
                                                    {middle, 1.1 * middle, 1.3 * middle}};
    const Relief relief{triangulate(region), radii, 0};
    const TriangleMesh mesh = wrap(relief);
    ASSERT_TRUE(is_closed_and_oriented(mesh));
    const ReliefTopology expected = topology(relief);
    EXPECT_EQ(components(mesh), expected.pieces);
    EXPECT_EQ(genus(mesh), expected.genus);
    const double volume = area_mm2(region, 0) * share(0.9 * middle, middle, around) +
                          area_mm2(region, 1) * share(middle, 1.3 * middle, around);
    EXPECT_NEAR(volume_mm3(mesh), volume, 1e-12 * volume);
    most_genus = std::max(most_genus, static_cast<double>(expected.genus));
  }
  EXPECT_GE(made, 50);
  EXPECT_GT(most_genus, 0);
  std::printf("seeds from %llu: %d of 60 made, largest genus %g\n",
              static_cast<unsigned long long>(seed), made, most_genus);
}

TEST(Layers, OfASingleSheetAreTheUnion) {
  const RandomPlane plane = random_plane(7501);
  const Region united = unite(plane.pattern, plane.grid, {}, 0.01);
  const Pattern closed = closed_pattern(plane.pattern, plane.grid, 0.01);
  const Region layered = layered_region({&closed, 1}, plane.grid, {}, [](unsigned s) { return s; });
  EXPECT_EQ(area_mm2(united), area_mm2(layered));
  EXPECT_EQ(outline_loops(united), outline_loops(layered));
  const Relief relief{triangulate(united), {{4, 5}}, 0};
  EXPECT_EQ(topology(relief).pieces, pieces(relief.plane));
  EXPECT_EQ(topology(relief).genus, outline_loops(united) - pieces(relief.plane));
}

TEST(Layers, ReachTheAxis) {
  // A rod of radius 5 and length 30 with a collar of radius 8 in its middle.
  const double around = 2 * std::numbers::pi * 5;
  const PlaneGrid grid = make_plane_grid(around, 30, sectors_for(8, 0.01));
  const Pattern collar{around, 30, {rectangle(0, around, 10, 20)}};
  const Pattern sheets[] = {draw_sleeve(5, 30), collar};
  const Region region = layered_region(sheets, grid, {}, [](unsigned s) { return s; });
  const Relief rod{triangulate(region), {{0, 5}, {5, 8}}, 100};
  const TriangleMesh mesh = wrap(rod);
  EXPECT_TRUE(is_closed_and_oriented(mesh));
  EXPECT_EQ(components(mesh), 1);
  EXPECT_EQ(genus(mesh), 0);
  EXPECT_EQ(topology(rod).pieces, 1);
  EXPECT_EQ(topology(rod).genus, 0);
  const double volume = std::numbers::pi * (25 * 30 + (64 - 25) * 10);
  EXPECT_NEAR(volume_mm3(mesh), volume, 1e-4 * volume);
}

TEST(Layers, NameThePlaceWhereMaterialTouchesItself) {
  const double around = 2 * std::numbers::pi * 10;
  const PlaneGrid grid = make_plane_grid(around, 20, 40);
  const Pattern squares{around, 20, {rectangle(5, 10, 2, 8), rectangle(10, 15, 8, 12)}};
  try {
    layered_region({&squares, 1}, grid, {}, [](unsigned s) { return s; });
    FAIL() << "a pinch went through";
  } catch (const GeometryError& fault) {
    EXPECT_NE(std::string(fault.what()).find("57.29"), std::string::npos) << fault.what();
    EXPECT_NE(std::string(fault.what()).find("z = 8"), std::string::npos) << fault.what();
  }
}

}  // namespace
}  // namespace latticast
