// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/audit.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh/weld.h"
#include "geometry/solid/tube_solids.h"
#include "tests/unit/geometry/solid/example_bodies.h"
#include "tests/unit/geometry/solid/example_segments.h"

namespace latticast {
namespace {

constexpr std::array<Defect, 8> all_defects{Defect::not_finite,        Defect::degenerate,
                                            Defect::open_edge,         Defect::crowded_edge,
                                            Defect::inconsistent_edge, Defect::pinched_vertex,
                                            Defect::self_intersection, Defect::inside_out};

// The defects found, by name, each with its number.
std::string found(const Audit& audit) {
  std::string text;
  for (const Defect defect : all_defects) {
    if (audit.count(defect) == 0) continue;
    text += std::string(name(defect)) + " " + std::to_string(audit.count(defect)) + "; ";
  }
  return text;
}

void expect_only(const Audit& audit, Defect defect, std::size_t count) {
  EXPECT_FALSE(audit.passes());
  EXPECT_EQ(found(audit), std::string(name(defect)) + " " + std::to_string(count) + "; ");
}

const Finding& first(const Audit& audit, Defect defect) {
  for (const Finding& finding : audit.findings) {
    if (finding.defect == defect) return finding;
  }
  throw std::runtime_error("no such finding");
}

bool lists(const Audit& audit, const Finding& expected) {
  for (const Finding& finding : audit.findings) {
    if (finding.defect == expected.defect && finding.where == expected.where &&
        finding.triangle == expected.triangle) {
      return true;
    }
  }
  return false;
}

void expect_passes(const TriangleMesh& mesh, int components, int genus, double volume) {
  const Audit result = audit(mesh);
  EXPECT_TRUE(result.passes()) << found(result);
  EXPECT_TRUE(result.searched_intersections);
  EXPECT_EQ(result.components, components);
  EXPECT_EQ(result.genus, genus);
  EXPECT_NEAR(result.volume_mm3, volume, 1e-12 * std::abs(volume));
}

TEST(GoodMesh, TetrahedronPasses) {
  expect_passes(tetrahedron(), 1, 0, 1.0 / 6);
  const Audit result = audit(tetrahedron());
  EXPECT_EQ(result.triangles, 4U);
  EXPECT_EQ(result.vertices, 4U);
  EXPECT_EQ(result.edges, 6U);
  EXPECT_NEAR(result.area_mm2, 1.5 + std::sqrt(3) / 2, 1e-15);
  EXPECT_EQ(result.lowest, (Point{0, 0, 0}));
  EXPECT_EQ(result.highest, (Point{1, 1, 1}));
}

TEST(GoodMesh, CubePassesAnywhere) {
  expect_passes(cube(), 1, 0, 1);
  expect_passes(placed(cube(), 0.5, {1000, -2000, 4096}), 1, 0, 0.125);
  expect_passes(placed(cube(), 1e-20, {0, 0, 0}), 1, 0, 1e-60);
  expect_passes(placed(cube(), 1e20, {0, 0, 0}), 1, 0, 1e60);
}

TEST(GoodMesh, TorusHasGenusOne) {
  const TriangleMesh mesh = torus();
  const Audit result = audit(mesh);
  EXPECT_TRUE(result.passes()) << found(result);
  EXPECT_EQ(result.components, 1);
  EXPECT_EQ(result.genus, 1);
}

TEST(GoodMesh, TwoBodiesAreTwoComponents) {
  expect_passes(together(cube(), placed(cube(), 1, {3, 0, 0})), 2, 0, 2);
  const Audit tori = audit(together(torus(), placed(torus(), 1, {0, 0, 9})));
  EXPECT_TRUE(tori.passes());
  EXPECT_EQ(tori.components, 2);
  EXPECT_EQ(tori.genus, 2);
}

TEST(GoodMesh, ACavityPassesWithItsOwnComponent) {
  const TriangleMesh cavity = turned_inside_out(placed(cube(), 0.5, {0.25, 0.25, 0.25}));
  expect_passes(together(cube(), cavity), 2, 0, 1 - 0.125);
}

TEST(GoodMesh, UnusedVerticesDoNotCount) {
  TriangleMesh mesh = cube();
  mesh.vertices.push_back({7, 7, 7});
  const Audit result = audit(mesh);
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.vertices, 8U);
  EXPECT_EQ(result.highest, (Point{1, 1, 1}));
}

TEST(BadMesh, MissingTriangleOpensThreeEdges) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.pop_back();  // the slanted face
  const Audit result = audit(mesh);
  expect_only(result, Defect::open_edge, 3);
  EXPECT_TRUE(lists(result, {Defect::open_edge, {0.5, 0.5, 0}, 0}));
  EXPECT_TRUE(lists(result, {Defect::open_edge, {0.5, 0, 0.5}, 1}));
  EXPECT_TRUE(lists(result, {Defect::open_edge, {0, 0.5, 0.5}, 2}));
}

TEST(BadMesh, FlippedTriangleRunsAgainstItsNeighbours) {
  TriangleMesh mesh = cube();
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);  // 1 5 4
  const Audit result = audit(mesh);
  expect_only(result, Defect::inconsistent_edge, 3);
  EXPECT_EQ(first(result, Defect::inconsistent_edge).where, (Point{0.5, 0, 0.5}));
}

TEST(BadMesh, ThreeTrianglesOnAnEdgeCrowdIt) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({0.5, -1, 0});
  mesh.triangles.push_back({0, 1, 4});  // a fin on the edge 0 1
  const Audit result = audit(mesh);
  EXPECT_EQ(result.count(Defect::crowded_edge), 1U);
  EXPECT_EQ(result.count(Defect::open_edge), 2U);
  EXPECT_EQ(first(result, Defect::crowded_edge).where, (Point{0.5, 0, 0}));
}

TEST(BadMesh, TwoBodiesThatShareAnEdgeCrowdIt) {
  TriangleMesh both = together(tetrahedron(), placed(tetrahedron(), -1, {0, 0, 0}));
  for (std::size_t t = 4; t < 8; ++t) std::swap(both.triangles[t][1], both.triangles[t][2]);
  // The second is the first, turned half around z: it shares the edge along z.
  for (std::size_t v = 4; v < 8; ++v) both.vertices[v][2] = -both.vertices[v][2];
  for (std::size_t t = 4; t < 8; ++t) std::swap(both.triangles[t][1], both.triangles[t][2]);
  const Audit result = audit(weld(both));
  expect_only(result, Defect::crowded_edge, 1);
  EXPECT_EQ(first(result, Defect::crowded_edge).where, (Point{0, 0, 0.5}));
}

TEST(BadMesh, TwoBodiesThatShareAVertexPinchIt) {
  TriangleMesh other = turned_inside_out(placed(tetrahedron(), -1, {0, 0, 0}));
  const Audit result = audit(weld(together(tetrahedron(), other)));
  expect_only(result, Defect::pinched_vertex, 1);
  EXPECT_EQ(first(result, Defect::pinched_vertex).where, (Point{0, 0, 0}));
  EXPECT_EQ(result.components, 2);
}

TEST(BadMesh, CoordinatesThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = cube();
    mesh.vertices[7][1] = bad;
    const Audit result = audit(mesh);
    EXPECT_FALSE(result.passes());
    EXPECT_EQ(result.count(Defect::not_finite), 3U);  // corners of triangles at vertex 7
    EXPECT_FALSE(result.searched_intersections);
  }
}

TEST(BadMesh, CollapsedTriangles) {
  TriangleMesh twice = tetrahedron();
  twice.triangles.push_back({1, 1, 2});
  EXPECT_EQ(audit(twice).count(Defect::degenerate), 1U);

  TriangleMesh line = cube();
  line.vertices.push_back({0.5, 0.5, 0});
  line.triangles[0] = {0, 2, 1};
  line.triangles.push_back({1, 8, 2});  // 8 is the middle of 1 2
  const Audit result = audit(line);
  EXPECT_EQ(result.count(Defect::degenerate), 1U);
  EXPECT_EQ(first(result, Defect::degenerate).triangle, 12U);
}

TEST(BadMesh, ATriangleOneFloatStepHighIsNotCollapsed) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices[3] = {0.3F, 0.3F, std::numeric_limits<float>::min()};
  const Audit result = audit(mesh);
  EXPECT_EQ(result.count(Defect::degenerate), 0U);
  EXPECT_TRUE(result.passes()) << found(result);
}

TEST(BadMesh, BodiesThatReachIntoEachOther) {
  const Audit result = audit(together(tetrahedron(), placed(tetrahedron(), 1, {0.2, 0.2, 0.2})));
  EXPECT_FALSE(result.passes());
  EXPECT_GT(result.count(Defect::self_intersection), 0U);
  EXPECT_EQ(found(result), std::string(name(Defect::self_intersection)) + " " +
                               std::to_string(result.count(Defect::self_intersection)) + "; ");
}

TEST(BadMesh, BodiesThatTouchWithoutSharingVertices) {
  // A corner against the middle of a face.
  const TriangleMesh corner = placed(tetrahedron(), 1, {1, 0.25, 0.25});
  EXPECT_GT(audit(together(cube(), corner)).count(Defect::self_intersection), 0U);
  // Face against face, offset.
  const TriangleMesh face = placed(cube(), 0.5, {1, 0.25, 0.25});
  EXPECT_GT(audit(together(cube(), face)).count(Defect::self_intersection), 0U);
  // A hair's breadth apart is not touching.
  const TriangleMesh near = placed(tetrahedron(), 1, {1 + 0x1p-23, 0.25, 0.25});
  EXPECT_TRUE(audit(together(cube(), near)).passes());
}

TEST(BadMesh, AFoldedPairOfTriangles) {
  // A closed surface without volume in one corner: two triangles over one another, sharing an edge.
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  const Audit result = audit(mesh);
  EXPECT_EQ(result.count(Defect::self_intersection), 1U);
  EXPECT_EQ(first(result, Defect::self_intersection).triangle, 0U);
  // Lifted out of the plane by the smallest float32 step there, it is a proper edge.
  mesh.vertices[3][2] = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(audit(mesh).count(Defect::self_intersection), 0U);
  // Laid open to the other side it is flat, but no fold.
  mesh.vertices[3] = {0.5, -0.5, 0};
  EXPECT_EQ(audit(mesh).count(Defect::self_intersection), 0U);
}

TEST(BadMesh, TrianglesThatOverlapBeyondASharedVertex) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0.5, 0}, {0.5, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(audit(mesh).count(Defect::self_intersection), 1U);
  // The second triangle's far side pierces the first.
  mesh.vertices[3] = {0.6, 0.6, -1};
  mesh.vertices[4] = {0.6, 0.6, 1};
  EXPECT_EQ(audit(mesh).count(Defect::self_intersection), 1U);
  // Only the vertex in common.
  mesh.vertices[3] = {-1, -0.5, 0};
  mesh.vertices[4] = {-0.5, -1, 0};
  EXPECT_EQ(audit(mesh).count(Defect::self_intersection), 0U);
}

TEST(BadMesh, TheSameTriangleTwiceIntersectsItself) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.push_back(mesh.triangles[0]);
  const Audit result = audit(mesh);
  EXPECT_EQ(result.count(Defect::self_intersection), 1U);
  EXPECT_EQ(result.count(Defect::crowded_edge), 3U);
}

TEST(BadMesh, TurnedInsideOut) {
  expect_only(audit(turned_inside_out(torus())), Defect::inside_out, 1);
}

TEST(BadMesh, OneOfTwoBodiesTurnedInsideOut) {
  // The larger body's volume must not hide the smaller one's.
  const TriangleMesh small = turned_inside_out(placed(cube(), 0.5, {3, 0, 0}));
  const Audit result = audit(together(cube(), small));
  expect_only(result, Defect::inside_out, 1);
  EXPECT_GE(first(result, Defect::inside_out).triangle, 12U);
}

TEST(BadMesh, ABodyInsideABodyIsNoCavity) {
  const TriangleMesh inner = placed(cube(), 0.5, {0.25, 0.25, 0.25});
  const Audit result = audit(together(cube(), inner));
  expect_only(result, Defect::inside_out, 1);
  EXPECT_GE(first(result, Defect::inside_out).triangle, 12U);
}

TEST(GoodMesh, ABodyInsideACavityPasses) {
  const TriangleMesh cavity = turned_inside_out(placed(cube(), 0.5, {0.25, 0.25, 0.25}));
  const TriangleMesh core = placed(cube(), 0.25, {0.375, 0.375, 0.375});
  expect_passes(together(core, together(cavity, cube())), 3, 0, 1 - 0.125 + 0.25 * 0.25 * 0.25);
}

TEST(GoodMesh, ABodyInATorusHoleIsNotInsideIt) {
  const Audit result = audit(together(torus(), placed(cube(), 1, {-0.5, -0.5, -0.5})));
  EXPECT_TRUE(result.passes()) << found(result);
}

TEST(Audit, ListsOnlyTheFirstFewOfEachDefectButCountsAll) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const double x = 3.0 * i;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Audit result = audit(mesh);
  expect_only(result, Defect::open_edge, 300);
  EXPECT_EQ(result.findings.size(), 5U);
  EXPECT_EQ(result.components, 100);
}

TEST(Audit, OfNothingPasses) {
  const Audit result = audit({});
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.components, 0);
  EXPECT_EQ(result.genus, 0);
  EXPECT_EQ(result.volume_mm3, 0);
}

TEST(Audit, FindsASingleTriangleTakenFromALattice) {
  SolidOptions options;
  options.tolerance_mm = 0.05;
  TriangleMesh mesh = weld(lattice_solid(example_segment(), options).mesh);
  const Triangle taken = mesh.triangles[mesh.triangles.size() / 2];
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<long>(mesh.triangles.size() / 2));
  const Audit result = audit(mesh);
  expect_only(result, Defect::open_edge, 3);
  for (const Finding& finding : result.findings) {
    bool on_its_side = false;
    for (int i = 0; i < 3; ++i) {
      const Point& a = mesh.vertices[taken[i]];
      const Point& b = mesh.vertices[taken[(i + 1) % 3]];
      on_its_side |=
          finding.where == Point{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
    }
    EXPECT_TRUE(on_its_side);
  }
}

TEST(Audit, FindsAVertexPushedThroughTheOppositeFace) {
  SolidOptions options;
  options.tolerance_mm = 0.05;
  TriangleMesh mesh = weld(lattice_solid(example_segment(), options).mesh);
  Point& moved = mesh.vertices[mesh.triangles[0][0]];
  const double turn = moved[0] * moved[0] + moved[1] * moved[1] > 17 * 17 ? 15.0 / 18 : 19.0 / 16;
  moved[0] *= turn;
  moved[1] *= turn;
  EXPECT_GT(audit(mesh).count(Defect::self_intersection), 0U);
}

TEST(Audit, IsTheSameEveryTime) {
  SolidOptions options;
  options.tolerance_mm = 0.1;
  TriangleMesh mesh = weld(lattice_solid(example_segment(), options).mesh);
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 37) mesh.vertices[i][0] += 0.8;
  const Audit one = audit(mesh);
  const Audit two = audit(mesh);
  ASSERT_FALSE(one.passes());
  EXPECT_EQ(one.counts, two.counts);
  EXPECT_EQ(one.volume_mm3, two.volume_mm3);
  EXPECT_EQ(one.area_mm2, two.area_mm2);
  ASSERT_EQ(one.findings.size(), two.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].defect, two.findings[i].defect);
    EXPECT_EQ(one.findings[i].where, two.findings[i].where);
    EXPECT_EQ(one.findings[i].triangle, two.findings[i].triangle);
  }
}

}  // namespace
}  // namespace latticast
