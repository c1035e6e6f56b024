// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/off_file.h"

#include <array>
#include <sstream>
#include <vector>

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "design/file_error.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/example_meshes.h"

namespace latticast {
namespace {

std::string complaint(const std::string& text) {
  try {
    decode_off("a.off", text);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST(OffFile, IsPlainText) {
  EXPECT_EQ(encode_off(tetrahedron()),
            "OFF\n4 4 0\n0 0 0\n1 0 0\n0 2 0\n0 0 0.100000001\n"
            "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(OffFile, ReadsWhatOtherProgramsWrite) {
  const TriangleMesh mesh = decode_off(
      "a.off",
      "COFF # vertices with colours\r\n\r\n5 2 6\r\n# a square, then a triangle\n 0 0 0 255 0 0 "
      "255\n"
      "+1 0 0 1 0 0 1\n1 1 0 # third\n\t0 1e0 0\n\n0.5 0.5 -1E-2\n4 0 1 2 3 0.5 0.5 0.5\n3  4 0 1");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 0, 1}}));
  ASSERT_EQ(mesh.vertices.size(), 5U);
  EXPECT_EQ(mesh.vertices[1], (Point{1, 0, 0}));
  EXPECT_EQ(mesh.vertices[4], (Point{0.5, 0.5, -0.01F}));
  const std::string rest = "3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* const start : {"", "OFF ", "OFF\n", "COFF\n# counts\n"}) {
    EXPECT_EQ(decode_off("a.off", start + rest).triangles.size(), 1U) << start;
  }
}

TEST(OffFile, CgalReadsTheSameMesh) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TriangleMesh mesh = any_floats(seed);
    for (Point& point : mesh.vertices) {
      for (double& x : point) {
        x = std::isfinite(static_cast<float>(x)) ? static_cast<float>(x) : 0.0;
      }
    }
    std::istringstream text(encode_off(mesh));
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    ASSERT_TRUE(CGAL::IO::read_OFF(text, points, faces));
    ASSERT_EQ(points.size(), mesh.vertices.size());
    ASSERT_EQ(faces.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(static_cast<float>(points[i][axis]), static_cast<float>(mesh.vertices[i][axis]));
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_TRUE(std::equal(faces[i].begin(), faces[i].end(), mesh.triangles[i].begin(),
                             mesh.triangles[i].end()));
    }
  }
}

TEST(OffFile, CutAnywhereIsRefused) {
  const std::string text = encode_off(torus(6, 5));
  // The last line may lack its end, and the last corner some of its digits.
  for (std::size_t size = 0; size < text.rfind(' '); ++size) {
    EXPECT_NE(complaint(text.substr(0, size)), "") << size;
  }
}

TEST(OffFile, NamesWhatIsWrong) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  const auto expect = [&](const std::string& text, const std::string& words) {
    const std::string found = complaint(text);
    EXPECT_NE(found.find(words), std::string::npos) << found << "\n for\n" << text;
  };
  expect("NOFF\n3 1 0\n", "line 1: \"NOFF\" is not OFF, nor a count of vertices");
  expect("OFF BINARY\n3 1 0\n", "line 1: \"BINARY\" is not OFF");
  expect("OFF\n-3 1 0\n", "line 2: \"-3\"");
  expect("OFF\n3 x 0\n", "line 2: \"x\" is not a count of faces");
  expect("OFF\n3 1 0.5\n", "line 2: \"0.5\" is not a count of edges");
  expect("OFF\n3 1 0\n" + corners, "ends where a face should follow");
  expect("OFF\n99999999999 1 0\n" + corners, "ends where a vertex should follow");
  expect("OFF\n3 1 0\n0 0\n", "line 3: a vertex needs three numbers");
  expect("OFF\n3 1 0\n" + corners + "2 0 1\n", "line 6: a face needs three vertices");
  expect("OFF\n3 1 0\n" + corners + "3 0 1\n", "line 6: \"\" is not a vertex number");
  expect("OFF\n3 1 0\n" + corners + "3 0 1 3\n", "line 6: there is no vertex 3");
  expect("OFF\n3 1 0\n" + corners + "3 0 1 -1\n", "line 6: \"-1\" is not a vertex number");
  expect("OFF\n3 1 0\n" + corners + "99999999999 0 1 2\n", "line 6: \"\" is not a vertex number");
  expect("OFF\n3 1 0\n" + corners + "3 0 1 2\n3 0 1 2\n", "line 7: is left over");
}

}  // namespace
}  // namespace latticast
