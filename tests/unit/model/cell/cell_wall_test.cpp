// SPDX-License-Identifier: GPL-3.0-or-later
// The wall in its unit cell against a closed form and another finite-element program's cell.
#include "model/cell/cell_wall.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/cell/element_energy.h"
#include "model/prepared_segment.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/golden/finite_element_cell.h"
#include "tests/unit/model/cell/cell_meshes.h"
#include "tests/unit/model/cell/waves.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

TEST(CellWall, PointsOfAHomogeneousStretchHaveItsStress) {
  // A tube stretched along its axis while it grows thinner: F = diag(1/sqrt(l), 1/sqrt(l), l).
  const double stretch = 1.3;
  const double thinner = 1 / std::sqrt(stretch) - 1;
  const CellMesh mesh = bare_tube(12, 16, NeoHookean{0.08}, small_division, 1000);
  const CellHexahedron& element = mesh.hexahedra.front();
  std::array<std::array<double, 3>, 27> displacement{};
  for (std::size_t a = 0; a < 27; ++a) {
    displacement[a][0] = thinner * mesh.nodes[element.nodes[a]].radius_mm;
  }
  const auto points = element_points<27>(mesh, element, displacement, {stretch - 1, 0, 0, 0});
  ASSERT_EQ(points.size(), 27U);
  // dW/dF of mu/2 (I1 - 3) at the isochoric stretches, by hand: mu (F - I1/3 F^-T).
  const double first = 2 / stretch + stretch * stretch;
  const double across = 0.08 * (1 / std::sqrt(stretch) - first / 3 * std::sqrt(stretch));
  const double along = 0.08 * (stretch - first / 3 / stretch);
  for (const ElementPoint& point : points) {
    EXPECT_NEAR(point.gradient[8], stretch, 1e-9);
    EXPECT_NEAR(point.gradient[0], 1 + thinner, 1e-4);
    EXPECT_NEAR(point.stress[8], along, 3e-4 * along);
    EXPECT_NEAR(point.stress[4], across, 3e-4 * along);
    EXPECT_NEAR(point.stress[1], 0, 3e-4 * along);
    EXPECT_NEAR(std::hypot(point.place[0], point.place[1]), 14, 2);
  }
}

TEST(CellWall, BulgesAsAnotherProgramsCellDoes) {
  ModelChoice model = unit_cell();
  model.cell_error_percent = 1;
  const PreparedSegment prepared = prepare_segment(twisting_segment(36), model);
  ASSERT_TRUE(prepared.cell);
  CellWalls walls(*prepared.cell);
  double before = 0;
  for (const CellState& reference : finite_element_cell()) {
    const double pressure = reference.pressure_kpa;
    if (pressure != 20 && pressure != 60) continue;
    const Response response = predict(prepared, std::span(&pressure, 1));
    ASSERT_TRUE(response.states[0]) << pressure;
    const auto wall = walls.at(response.states[0]->deformation(12, 0));
    ASSERT_TRUE(wall) << pressure;
    const double bulge = reference.void_growth_mm - reference.ring_growth_mm;
    EXPECT_NEAR(wall->bulge_mm, bulge, 0.07 * bulge) << pressure << " kPa";
    EXPECT_GT(wall->lattice_strain, before);
    EXPECT_GT(wall->bond_shear_mpa, 0);
    before = wall->lattice_strain;
  }
}

TEST(CellWall, BondBearsWhatTheLinerDoesNot) {
  const Segment segment = twisting_segment(60);
  const PreparedSegment prepared = prepare_segment(segment, unit_cell());
  const double pressure = 10;
  const State state = predict(prepared, std::span(&pressure, 1)).states[0].value();
  const Deformation at = state.deformation(12, 0);
  const auto wall = CellWalls(*prepared.cell).at(at);
  ASSERT_TRUE(wall);
  // A tube of the liner alone bears its share at this state; the rest is on the covered area.
  const Section bare = prepare_section(tube(12, 16, NeoHookean{0.08}), {});
  const double by_bore = stored_energy(bare, make_quadrature(bare, 16, 1, 1, 1), at)
                             ->gradient[coordinate::inner_growth];
  const double own_kpa = 1e3 * by_bore / (2 * pi * state.inner_radius_mm * state.stretch);
  const double strips = 8 * 2 / std::sin(60 * degree) / (2 * pi * 17);
  const double rings = 2.0 / 10;
  const double covered = strips + rings - strips * rings;
  // Bulges and the strips' pull along themselves are not in this balance.
  EXPECT_NEAR(-1e3 * wall->bond_pull_mpa * covered, pressure - own_kpa,
              0.12 * (pressure - own_kpa));
}

}  // namespace
}  // namespace latticast::testing
