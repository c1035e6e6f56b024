// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/mesh_checks.h"

#include <limits>

#include <gtest/gtest.h>

#include "geometry/solid/tube_solids.h"
#include "tests/unit/checks/checked_designs.h"

namespace latticast {
namespace {

// Twelve triangles facing outwards, or inwards.
void add_box(TriangleMesh& mesh, Point low, Point high, bool outwards = true) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {(i & 1) ? high[0] : low[0], (i & 2) ? high[1] : low[1], (i & 4) ? high[2] : low[2]});
  }
  constexpr std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  for (const auto& f : faces) {
    for (Triangle t : {Triangle{f[0], f[1], f[2]}, Triangle{f[0], f[2], f[3]}}) {
      for (std::uint32_t& v : t) v += first;
      if (!outwards) std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
    }
  }
}

TEST(MeshChecks, FindNothingInASoundLattice) {
  EXPECT_TRUE(mesh_checks(lattice_solid(twisting_segment(), {0.05}).mesh, "lattice.stl").empty());
}

TEST(MeshChecks, FindEveryVoidWithItsVolume) {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {10, 10, 10});
  add_box(mesh, {1, 1, 1}, {3, 3, 3}, false);
  add_box(mesh, {5, 5, 5}, {9, 9, 8}, false);
  add_box(mesh, {6, 6, 6}, {7, 7, 7});
  const auto found = with_code(mesh_checks(mesh, "box.stl"), "enclosed-void");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(*found[0].value, 8, 1e-5);
  EXPECT_NEAR(*found[1].value, 48, 1e-5);
  EXPECT_EQ(found[0].part, "box.stl");
}

TEST(MeshChecks, CountEveryKindOfDefect) {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {10, 10, 10});
  mesh.triangles.pop_back();
  const auto open = with_code(mesh_checks(mesh, "box.stl"), "mesh-open-edge");
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(*open[0].value, 3);
  EXPECT_EQ(open[0].severity, Severity::error);
  mesh.vertices[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(with_code(mesh_checks(mesh, "box.stl"), "mesh-not-finite").size(), 1U);
}

CheckFindings plate_findings(double thickness, double from = 0) {
  TriangleMesh mesh;
  add_box(mesh, {from, 0, 0}, {from + thickness, 10, 10});
  return with_code(mesh_checks(mesh, "plate.stl"), "mesh-thin-wall");
}

TEST(MeshChecks, WarnOfThinWallsWithTheirPlaceAndShare) {
  const auto found = plate_findings(0.5, 3);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_NEAR(*found[0].value, 0.5, 1e-6);
  EXPECT_EQ(*found[0].limit, 0.8);
  EXPECT_NE(found[0].message.find("x 3.250"), std::string::npos) << found[0].message;
  EXPECT_NE(found[0].message.find("91 %"), std::string::npos) << found[0].message;  // 200 of 220
}

// Also where float32 rounds the thickness down, and where chords take a little off.
TEST(MeshChecks, AcceptWallsAtTheLimit) {
  for (const double from : {0.0, 0.1, 10.7, 100.3, -77.7}) {
    EXPECT_TRUE(plate_findings(0.8, from).empty()) << from;
    EXPECT_EQ(plate_findings(0.79, from).size(), 1U) << from;
  }
  Segment tube;
  tube.length_mm = 30;
  tube.liner = {12, 0.8, {}};
  EXPECT_TRUE(mesh_checks(liner_solid(tube, {0.05}).mesh, "liner.stl").empty());
}

TEST(MeshChecks, MeasureNoWallsOfBrokenMeshes) {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {0.5, 10, 10});
  mesh.triangles.pop_back();
  EXPECT_TRUE(with_code(mesh_checks(mesh, "box.stl"), "mesh-thin-wall").empty());
}

TEST(MeshChecks, WarnOfPartsBeyondAUsualBed) {
  const auto size = [](double x, double y, double z) {
    TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {x, y, z});
    return with_code(mesh_checks(mesh, "box.stl"), "exceeds-bed");
  };
  EXPECT_TRUE(size(220, 220, 250).empty());
  ASSERT_EQ(size(220, 220, 250.5).size(), 1U);
  EXPECT_EQ(size(220, 220, 250.5)[0].severity, Severity::warning);
  EXPECT_EQ(size(230, 1, 1).size(), 1U);
}

TEST(MeshChecks, JudgePartsOfAFileOneByOne) {
  const auto objects = [](double from) {
    std::vector<MeshObject> boxes{{"left", {}}, {"", {}}};
    add_box(boxes[0].mesh, {0, 0, 0}, {10, 20, 30});
    add_box(boxes[1].mesh, {from, 0, 0}, {from + 10, 20, 30});
    return boxes;
  };
  EXPECT_TRUE(mesh_checks(objects(10), "boxes.3mf").empty());
  const auto overlap = mesh_checks(objects(9), "boxes.3mf");
  ASSERT_EQ(overlap.size(), 1U);
  EXPECT_EQ(overlap[0].code, "parts-overlap");
  EXPECT_EQ(overlap[0].severity, Severity::note);
  EXPECT_NEAR(*overlap[0].value, 1, 1e-9);
  EXPECT_NE(overlap[0].message.find("\"left\" and object 2 overlap"), std::string::npos);
  auto broken = objects(10);
  broken[1].mesh.triangles.pop_back();
  const auto open = mesh_checks(broken, "boxes.3mf");
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].code, "mesh-open-edge");
  EXPECT_EQ(open[0].part, "boxes.3mf object 2");
}

}  // namespace
}  // namespace latticast
