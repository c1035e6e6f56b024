// SPDX-License-Identifier: GPL-3.0-or-later
// Prisms whose ends are one face each, as other programs write them.
#include <cmath>
#include <numbers>
#include <string>

#include <assimp/Exporter.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"

namespace latticast {
namespace {

using Outline = std::vector<std::array<double, 2>>;

struct Prism {
  std::string name;
  Outline outline;
  double volume_mm3;  ///< 10 mm high
};

const std::vector<Prism>& prisms() {
  static const std::vector<Prism> all{
      {"L", {{0, 0}, {20, 0}, {20, 5}, {5, 5}, {5, 20}, {0, 20}}, 1750},
      {"chevron", {{0, 0}, {10, 5}, {0, 10}, {3, 5}}, 350},
      {"T", {{0, 10}, {5, 10}, {5, 0}, {10, 0}, {10, 10}, {15, 10}, {15, 15}, {0, 15}}, 1250},
      {"straight corners", {{0, 0}, {5, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}}, 1000},
      {"star", {{10, 0}, {2, 2}, {0, 10}, {-2, 2}, {-10, 0}, {-2, -2}, {0, -10}, {2, -2}}, 800}};
  return all;
}

/// Vertices 2 i below and 2 i + 1 above; two faces for the ends, and one for each side.
std::vector<std::vector<std::size_t>> faces_of(const Prism& prism) {
  std::vector<std::vector<std::size_t>> faces(2);
  const std::size_t count = prism.outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    faces[0].push_back(2 * (count - 1 - i));
    faces[1].push_back(2 * i + 1);
    faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  return faces;
}

std::string text_of(const Prism& prism, const std::string& vertex, const std::string& face,
                    std::size_t first) {
  std::string text;
  for (const auto& [x, y] : prism.outline) {
    for (const char* z : {" 0\n", " 10\n"}) {
      text += vertex + std::to_string(x) + " " + std::to_string(y) + z;
    }
  }
  for (const auto& corners : faces_of(prism)) {
    text += face.empty() ? std::to_string(corners.size()) : face;
    for (const std::size_t corner : corners) text += " " + std::to_string(corner + first);
    text += "\n";
  }
  return text;
}

std::string counts(const Prism& prism, const std::string& between) {
  return std::to_string(2 * prism.outline.size()) + between +
         std::to_string(prism.outline.size() + 2);
}

void expect_sound(const TriangleMesh& mesh, const Prism& prism) {
  SCOPED_TRACE(prism.name);
  const Audit found = audit(weld(mesh));
  EXPECT_TRUE(found.passes());
  EXPECT_EQ(found.components, 1);
  EXPECT_NEAR(found.volume_mm3, prism.volume_mm3, 1e-3);
}

TEST(PolygonFaces, OfObjPlyAndOffAreSound) {
  for (const Prism& prism : prisms()) {
    expect_sound(read_mesh_bytes("a.obj", text_of(prism, "v ", "f", 1)), prism);
    expect_sound(
        read_mesh_bytes("a.off", "OFF\n" + counts(prism, " ") + " 0\n" + text_of(prism, "", "", 0)),
        prism);
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex " +
        counts(prism, "\nproperty float x\nproperty float y\nproperty float z\nelement face ") +
        "\nproperty list uchar int vertex_indices\nend_header\n";
    expect_sound(read_mesh_bytes("a.ply", header + text_of(prism, "", "", 0)), prism);
  }
}

/// Corners carry numbers of normals, as Blender writes them.
TEST(PolygonFaces, WithNormals) {
  for (const Prism& prism : prisms()) {
    std::string text = "o Cube\n" + text_of(prism, "v ", "s off\nf", 1);
    for (std::size_t at = text.find("\nf"); at != std::string::npos;
         at = text.find("\nf", at + 1)) {
      for (std::size_t i = text.find(' ', at + 3); i < text.find('\n', at + 1);
           i = text.find(' ', i + 5)) {
        text.insert(i, "//1");
      }
    }
    expect_sound(read_mesh_bytes("a.obj", text + "vn 0 0 1\n"), prism);
  }
}

/// A square with a square hole in one face, whose outline goes to the hole and back.
TEST(PolygonFaces, WithAKeyhole) {
  const Prism ring{
      "keyhole", {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 3}, {7, 3}, {7, 7}, {3, 7}}, 840};
  std::string text = text_of(ring, "v ", "f", 1);
  text.erase(text.find("f "));
  const auto number = [](std::size_t corner, bool above) {
    return " " + std::to_string(2 * corner + (above ? 2 : 1));
  };
  const std::vector<std::size_t> path{0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
  std::string above = "f";
  std::string below;
  for (const std::size_t corner : path) {
    above += number(corner, true);
    below.insert(0, number(corner, false));
  }
  text += above + "\nf" + below + "\n";
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t next = i % 4 == 3 ? i - 3 : i + 1;
    const std::size_t from = i < 4 ? i : next;
    const std::size_t to = i < 4 ? next : i;
    text += "f" + number(from, false) + number(to, false) + number(to, true) + number(from, true) +
            "\n";
  }
  const Audit found = audit(weld(read_mesh_bytes("a.obj", text)));
  EXPECT_TRUE(found.passes());
  EXPECT_EQ(found.genus, 1);
  EXPECT_NEAR(found.volume_mm3, ring.volume_mm3, 1e-3);
}

// The scene frees what is put into it.
// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks)
std::unique_ptr<aiScene> assimp_scene(const Prism& prism) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mNumVertices = static_cast<unsigned>(2 * prism.outline.size());
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  for (std::size_t i = 0; i < prism.outline.size(); ++i) {
    const auto x = static_cast<float>(prism.outline[i][0]);
    const auto y = static_cast<float>(prism.outline[i][1]);
    mesh->mVertices[2 * i] = {x, y, 0};
    mesh->mVertices[2 * i + 1] = {x, y, 10};
  }
  const auto faces = faces_of(prism);
  mesh->mNumFaces = static_cast<unsigned>(faces.size());
  mesh->mFaces = new aiFace[faces.size()];
  for (std::size_t i = 0; i < faces.size(); ++i) {
    mesh->mFaces[i].mNumIndices = static_cast<unsigned>(faces[i].size());
    mesh->mFaces[i].mIndices = new unsigned[faces[i].size()];
    std::copy(faces[i].begin(), faces[i].end(), mesh->mFaces[i].mIndices);
  }
  mesh->mPrimitiveTypes = aiPrimitiveType_POLYGON;
  auto scene = std::make_unique<aiScene>();
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { mesh.release() };
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mRootNode = new aiNode("part");
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  return scene;
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

TEST(PolygonFaces, OfAssimpAreSound) {
  for (const Prism& prism : prisms()) {
    const auto scene = assimp_scene(prism);
    for (const char* format : {"obj", "ply", "plyb"}) {
      Assimp::Exporter exporter;
      const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format);
      ASSERT_NE(blob, nullptr) << exporter.GetErrorString();
      const std::string bytes(static_cast<const char*>(blob->data), blob->size);
      expect_sound(read_mesh_bytes(format == std::string("obj") ? "a.obj" : "a.ply", bytes), prism);
    }
  }
}

/// All corners at one vertex would make an audit compare each triangle with each.
TEST(PolygonFaces, ARoundFaceHasNoCornerWithMostOfItsTriangles) {
  Prism round{"round", {}, 0};
  constexpr int corners = 5000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    round.outline.push_back({20 * std::cos(angle), 20 * std::sin(angle)});
  }
  const TriangleMesh mesh = read_mesh_bytes("a.obj", text_of(round, "v ", "f", 1));
  std::vector<int> uses(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) ++uses[corner];
  }
  EXPECT_LT(*std::max_element(uses.begin(), uses.end()), 100);
}

}  // namespace
}  // namespace latticast
