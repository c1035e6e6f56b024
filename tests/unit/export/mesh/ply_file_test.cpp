// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/ply_file.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <assimp/Importer.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/example_meshes.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

TriangleMesh read(const std::string& bytes) {
  return decode_ply("a.ply", bytes);
}

/// Numbers one after the other, each in its own type and byte order.
class BinaryText {
 public:
  explicit BinaryText(bool big_endian) : big_endian_(big_endian) {}

  template <typename Number>
  BinaryText& put(Number value) {
    std::array<char, sizeof value> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian_) {
      std::reverse(bytes.begin(), bytes.end());
    }
    text.append(bytes.data(), bytes.size());
    return *this;
  }

  std::string text;

 private:
  bool big_endian_;
};

/// A box of 10 x 20 x 30 as strips, by a face each, which -1 parts; or one that turns in place.
TEST(PlyFile, ReadsTriangleStrips) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n10 0 0\n0 20 0\n10 20 0\n0 0 30\n10 0 30\n0 20 30\n10 20 30\n";
  const std::vector<Triangle> expected{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {6, 5, 7}};
  EXPECT_EQ(read(header + "10 0 2 1 3 -1 4 5 6 7 -1").triangles, expected);
  // 3 and 4 twice each join the two, and make the second begin the right way round.
  EXPECT_EQ(read(header + "10 0 2 1 3 3 4 4 5 6 7").triangles, expected);
  EXPECT_EQ(read(header + "7 0 2 1 -1 4 5 6").triangles,
            (std::vector<Triangle>{{0, 2, 1}, {4, 5, 6}}));
  EXPECT_THROW(read(header + "3 0 1 8"), FileError);
  EXPECT_THROW(read(header + "3 0 1 -2"), FileError);
  EXPECT_THROW(read(header + "3 0 1"), FileError);
}

TEST(PlyFile, SpellsOutItsHeaderAndBytes) {
  const TriangleMesh mesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}}, {{2, 0, 1}}};
  const std::vector<Colour> colours{{0, 0.5, 1}, {-1, 2, 0.999}, {0.2, 0.4, 0.6}};
  BinaryText body(false);
  body.put(1.0F).put(0.0F).put(0.0F).put<char>(0).put<std::uint8_t>(128).put<std::uint8_t>(255);
  body.put(0.0F).put(1.0F).put(0.0F).put<char>(0).put<std::uint8_t>(255).put<std::uint8_t>(255);
  body.put(0.0F).put(0.0F).put(0.1F).put<char>(51).put<char>(102).put<std::uint8_t>(153);
  body.put<char>(3).put(2).put(0).put(1);
  EXPECT_EQ(encode_ply(mesh, {.vertex_colours = colours}),
            "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex 3\n"
            "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n" +
                body.text);
}

TEST(PlyFile, HasTheQualityOfItsVertices) {
  const TriangleMesh mesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}}, {{2, 0, 1}}};
  const std::vector<double> strains{0.25, -0.5, 1};
  const std::string bytes = encode_ply(mesh, {.vertex_qualities = strains});
  EXPECT_NE(bytes.find("property float z\nproperty float quality\nelement face 1\n"),
            std::string::npos);
  const std::size_t body = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size(), body + 3 * 16 + 13);
  for (std::size_t i = 0; i < 3; ++i) {
    float value = 0;
    std::memcpy(&value, bytes.data() + body + 16 * i + 12, 4);
    EXPECT_EQ(value, static_cast<float>(strains[i]));
  }
  expect_same_mesh(read(bytes), mesh);
}

TEST(PlyFile, KeepsNumberingWithAndWithoutColours) {
  for (const TriangleMesh& mesh : {hard_mesh(), torus(33, 9), any_floats(3), tetrahedron()}) {
    expect_same_mesh(read(encode_ply(mesh)), mesh);
    const std::vector<Colour> colours(mesh.vertices.size(), Colour{0.1, 0.2, 0.3});
    expect_same_mesh(read(encode_ply(mesh, {.vertex_colours = colours})), mesh);
  }
}

TEST(PlyFile, AssimpReadsTheSameColours) {
  const TestFolder folder;
  const TriangleMesh mesh = torus(9, 5);
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    colours.push_back({static_cast<double>(i) / 255, static_cast<double>(2 * i) / 255, 1});
  }
  write_mesh(folder / "a.ply", mesh, MeshFormat::ply, {.vertex_colours = colours});
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "a.ply").string(), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiMesh& seen = *scene->mMeshes[0];
  ASSERT_EQ(seen.mNumVertices, mesh.vertices.size());
  ASSERT_EQ(seen.mNumFaces, mesh.triangles.size());
  for (unsigned i = 0; i < seen.mNumVertices; ++i) {
    EXPECT_EQ(bits(seen.mVertices[i].x), bits(mesh.vertices[i][0]));
    EXPECT_NEAR(seen.mColors[0][i].r, colours[i].red, 1e-6);
    EXPECT_NEAR(seen.mColors[0][i].g, colours[i].green, 1e-6);
    EXPECT_NEAR(seen.mColors[0][i].b, 1, 1e-6);
  }
}

TEST(PlyFile, NeedsAColourForEachVertex) {
  const TestFolder folder;
  const std::vector<Colour> colours(3);
  EXPECT_THROW(
      write_mesh(folder / "a.ply", tetrahedron(), MeshFormat::ply, {.vertex_colours = colours}),
      std::invalid_argument);
  EXPECT_TRUE(folder.names().empty());
}

TEST(PlyFile, ReadsTextWithPolygonsAndWhatElseThereIs) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\ncomment folder\\\nobj_info none\nelement material 1\n"
      "property list int8 float weights\nproperty uchar kind\n"
      "element vertex 5\nproperty list uchar short neighbours\nproperty double z\n"
      "property uint8 red\nproperty int32 x\nproperty float32 y\n"
      "element face 2\nproperty float area\nproperty list ushort uint16 vertex_index\n"
      "element edge 1\nproperty int vertex1\nelement nothing 4000000000000\nend_header\n"
      "2 0.5 1e-3 7\n"
      "0 0 255 0 0\n1 3 0 255 1 0\n0 0 255 1 1\n2 5 6 0 255 0 1\n0 2 255 0 0.1\n"
      "1 4 0 1 2 3\n0.5 3 0 1 4\n12\n\n";
  const TriangleMesh expected{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.1, 2}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}};
  expect_same_mesh(read(text), expected);
}

/// Every type in both byte orders; the face comes before the vertices that it names.
TEST(PlyFile, ReadsEveryBinaryTypeInBothByteOrders) {
  for (const bool big_endian : {false, true}) {
    BinaryText body(big_endian);
    body.put<std::uint16_t>(4).put<std::int8_t>(0).put<std::int8_t>(1).put<std::int8_t>(2);
    body.put<std::int8_t>(3).put<std::uint32_t>(1).put(2.5);
    body.put<std::int16_t>(-300).put(0.1).put(0.1F);
    body.put<std::int16_t>(4).put(1e300).put(-0.0F);
    body.put<std::int16_t>(32767).put(1e-320).put(3.0F);
    body.put<std::int16_t>(0).put(16777217.0).put(3.0F);
    const TriangleMesh mesh =
        read(std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
             "_endian 1.0\nelement face 1\nproperty list ushort char vertex_indices\n"
             "property list uint double more\nelement vertex 4\nproperty short x\n"
             "property double y\nproperty float z\nend_header\n" +
             body.text);
    const double infinity = std::numeric_limits<double>::infinity();
    expect_same_mesh(mesh,
                     {{{-300, 0.1F, 0.1F}, {4, infinity, -0.0}, {32767, 0, 3}, {0, 16777216, 3}},
                      {{0, 1, 2}, {0, 2, 3}}});
  }
}

}  // namespace
}  // namespace latticast
