// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of the unit cell: derivatives against differences, the patch test, and a rotated world.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "model/cell/element_energy.h"
#include "tests/unit/model/cell/cell_meshes.h"
#include "tests/unit/model/cell/derivatives.h"

namespace latticast::testing {
namespace {

TEST(CellElement, HasItsDerivatives) {
  const CellMesh mesh = strip_cell(strips(36), small_division);
  Random random(4);
  for (const std::size_t e : {std::size_t{0}, mesh.hexahedra.size() - 1}) {
    const auto evaluated = [&](const Components<27>& u, const TubeStrain& q) {
      ElementEnergy<27> result;
      EXPECT_TRUE(evaluate(mesh, mesh.hexahedra[e], u, q, nullptr, result));
      return result;
    };
    expect_derivatives(random_components<27>(random, 0.1), evaluated, 10);
  }
}

TEST(CellElement, CavityHasItsDerivatives) {
  const CellMesh mesh = strip_cell(strips(36), small_division);
  Random random(5);
  const auto evaluated = [&](const Components<9>& u, const TubeStrain& q) {
    CavityPart<9> result;
    evaluate(mesh, mesh.bore_quadrilaterals[2], u, q, result);
    return result;
  };
  expect_derivatives(random_components<9>(random, 0.3), evaluated, 1);
}

TEST(CellElement, CavityOfARoundBoreIsItsCylinder) {
  // pi a^2 lambda per mm, whatever the tube twists and bends about its axis by: the sum over all
  // images around it.
  constexpr double growth = 0.7;
  const CellMesh mesh = strip_cell(strips(36), small_division);
  Components<9> grown{};
  for (auto& node : grown) node[0] = growth;
  double volume = 0;
  for (int image = 0; image < 8; ++image) {
    CellMesh turned = mesh;
    for (CellNode& node : turned.nodes) node.angle_rad += image * pi / 4;
    for (const auto& face : turned.bore_quadrilaterals) {
      CavityPart<9> part;
      evaluate(turned, face, grown, {0.3, 0.02, 0.003, -0.002}, part);
      volume += part.volume_mm3;
    }
  }
  const double length = 5;
  EXPECT_NEAR(volume / length, pi * 12.7 * 12.7 * 1.3, 2e-4 * volume / length);
}

/// Node forces of the mesh, as Cartesian vectors, under a displacement field of places at rest.
template <class Field>
std::vector<std::array<double, 3>> node_forces(const CellMesh& mesh, const Field& field) {
  std::vector<std::array<double, 3>> forces(mesh.nodes.size());
  ElementEnergy<27> part;
  for (const CellHexahedron& element : mesh.hexahedra) {
    Components<27> u{};
    for (std::size_t a = 0; a < 27; ++a) u[a] = field(mesh.nodes[element.nodes[a]]);
    EXPECT_TRUE(evaluate(mesh, element, u, {}, nullptr, part));
    for (std::size_t a = 0; a < 27; ++a) {
      for (std::size_t c = 0; c < 3; ++c) {
        forces[element.nodes[a]][c] += part.gradient[3 * a + c];
      }
    }
  }
  return forces;
}

TEST(CellElement, PassesThePatchTest) {
  // One deformation gradient everywhere, in a curved and graded mesh of one material: no force
  // reaches an inner node.
  CellMesh mesh = bare_tube(12, 16, NeoHookean{0.08}, small_division, 10);
  // Inner nodes are those that no face of the patch has: off the radii, heights and sides.
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  for (const CellNode& node : mesh.nodes) {
    lowest = std::min(lowest, node.height_mm);
    highest = std::max(highest, node.height_mm);
  }
  std::vector<int> owners(mesh.nodes.size());
  for (const CellHexahedron& element : mesh.hexahedra) {
    for (const std::int32_t node : element.nodes) ++owners[node];
  }
  const auto forces = node_forces(mesh, uniform_gradient);
  double largest = 0;
  double inner = 0;
  int inner_nodes = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const double force = std::hypot(forces[i][0], forces[i][1], forces[i][2]);
    largest = std::max(largest, force);
    // A corner that eight elements share is inside of the patch.
    if (owners[i] < 8) continue;
    inner = std::max(inner, force);
    ++inner_nodes;
  }
  ASSERT_GT(inner_nodes, 0);
  ASSERT_GT(largest, 1e-3);
  EXPECT_LT(inner, 1e-13 * largest);
}

TEST(CellElement, DoesNotKnowWhereAroundTheTubeItIs) {
  const CellMesh mesh = strip_cell(strips(36), small_division);
  CellMesh turned = mesh;
  for (CellNode& node : turned.nodes) node.angle_rad += 0.7;
  Random random(6);
  const Components<27> u = random_components<27>(random, 0.1);
  ElementEnergy<27> here;
  ElementEnergy<27> there;
  const TubeStrain straight = {0.1, 0.01, 0, 0};
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    ASSERT_TRUE(evaluate(mesh, mesh.hexahedra[e], u, straight, nullptr, here));
    ASSERT_TRUE(evaluate(turned, turned.hexahedra[e], u, straight, nullptr, there));
    EXPECT_NEAR(there.energy, here.energy, 1e-12 * here.energy);
    for (int i = 0; i < 83; ++i) {
      EXPECT_NEAR(there.gradient[i], here.gradient[i], 1e-10 * (1 + std::abs(here.gradient[i])));
    }
  }
}

}  // namespace
}  // namespace latticast::testing
