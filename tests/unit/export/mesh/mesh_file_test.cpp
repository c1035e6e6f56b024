// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/mesh_formats.h"
#include "geometry/mesh/weld.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/example_meshes.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

TriangleMesh read_by_assimp(const std::filesystem::path& file) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  TriangleMesh mesh;
  const aiMesh& read = *scene->mMeshes[0];
  for (unsigned i = 0; i < read.mNumVertices; ++i) {
    mesh.vertices.push_back({read.mVertices[i].x, read.mVertices[i].y, read.mVertices[i].z});
  }
  for (unsigned i = 0; i < read.mNumFaces; ++i) {
    const unsigned* corner = read.mFaces[i].mIndices;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return mesh;
}

// assimp's structures free what they point to, which the analyser cannot know.
// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks)
/// A scene of one mesh below the root, moved by `offset`.
std::unique_ptr<aiScene> assimp_scene(const TriangleMesh& mesh, const aiVector3D& offset) {
  auto part = std::make_unique<aiMesh>();
  part->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  part->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  part->mVertices = new aiVector3D[mesh.vertices.size()];
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point& p = mesh.vertices[i];
    part->mVertices[i] =
        aiVector3D(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
  }
  part->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
  part->mFaces = new aiFace[mesh.triangles.size()];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    part->mFaces[i].mNumIndices = 3;
    part->mFaces[i].mIndices = new unsigned[3];
    std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), part->mFaces[i].mIndices);
  }
  auto scene = std::make_unique<aiScene>();
  scene->mMeshes = new aiMesh* [1] { part.release() };
  scene->mNumMeshes = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mNumMaterials = 1;
  auto* child = new aiNode("part");
  child->mMeshes = new unsigned[1]{0};
  child->mNumMeshes = 1;
  aiMatrix4x4::Translation(offset, child->mTransformation);
  scene->mRootNode = new aiNode("root");
  scene->mRootNode->addChildren(1, &child);
  return scene;
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

std::vector<MeshFormat> all_mesh_formats() {
  std::vector<MeshFormat> formats;
  formats.reserve(mesh_format_names.size());
  for (const MeshFormatName& known : mesh_format_names) formats.push_back(known.format);
  return formats;
}

class MeshFile : public testing::TestWithParam<MeshFormat> {
 protected:
  std::filesystem::path file(const std::string& name) const {
    return folder_ / (name + std::string(extension(GetParam())));
  }
  TestFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Written, MeshFile, testing::ValuesIn(all_mesh_formats()),
                         [](const auto& instance) {
                           std::string name(extension(instance.param).substr(1));
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST_P(MeshFile, ReadsBackBitForBit) {
  const TriangleMesh mesh = torus(97, 31);
  write_mesh(file("a"), mesh, GetParam());
  expect_same_corners(read_mesh(file("a")), mesh);
}

TEST_P(MeshFile, ReadsBackEveryFloat) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TriangleMesh mesh = any_floats(seed);
    if (!mesh_file_format(GetParam()).keeps_infinite) {
      EXPECT_THROW(write_mesh(file("a"), mesh, GetParam()), std::invalid_argument);
      for (Point& point : mesh.vertices) {
        for (double& x : point) {
          x = std::isfinite(static_cast<float>(x)) ? x : -0.0;
        }
      }
    }
    write_mesh(file("a"), mesh, GetParam());
    expect_same_corners(read_mesh(file("a")), mesh);
  }
}

TEST_P(MeshFile, KeepsNumberingOfHardMeshes) {
  for (const TriangleMesh& mesh : {hard_mesh(), tetrahedron()}) {
    write_mesh(file("a"), mesh, GetParam());
    const TriangleMesh read = read_mesh(file("a"));
    expect_same_corners(read, mesh);
    if (mesh_file_format(GetParam()).keeps_vertex_numbers) {
      expect_same_mesh(read, mesh);
    }
  }
}

TEST_P(MeshFile, HoldsAHundredThousandTriangles) {
  const TriangleMesh mesh = torus(500, 100);
  write_mesh(file("a"), mesh, GetParam());
  expect_same_corners(read_mesh(file("a")), mesh);
}

TEST_P(MeshFile, KeepsCollapsedTrianglesAndTheirOrder) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.insert(mesh.triangles.begin() + 1, {1, 1, 2});
  mesh.triangles.push_back({3, 3, 3});
  write_mesh(file("a"), mesh, GetParam());
  expect_same_corners(read_mesh(file("a")), mesh);
}

TEST_P(MeshFile, BytesDependOnTheMeshAlone) {
  for (const std::string folder : {"first", "second"}) {
    std::filesystem::create_directory(folder_ / folder);
    write_mesh(file(folder + "/a"), torus(40, 12), GetParam());
  }
  EXPECT_EQ(bytes_of(file("first/a")), bytes_of(file("second/a")));
  write_mesh(file("b"), torus(40, 12), GetParam());
  const bool named = mesh_file_format(GetParam()).keeps_part_name;
  EXPECT_EQ(bytes_of(file("first/a")) == bytes_of(file("b")), !named);
  EXPECT_EQ(folder_.names().size(), 3U);  // two folders, a file and no other
}

TEST_P(MeshFile, AssimpReadsTheSameTriangles) {
  const TriangleMesh mesh = torus(40, 12);
  write_mesh(file("a"), mesh, GetParam());
  const TriangleMesh read = read_by_assimp(file("a"));
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // assimp's own text reader is off by the last bit now and then.
        EXPECT_NEAR(read.vertices[read.triangles[i][corner]][axis],
                    mesh.vertices[mesh.triangles[i][corner]][axis], 2e-6);
      }
    }
  }
}

TEST_P(MeshFile, AFailureLeavesTheOldFile) {
  put_bytes(file("a"), "old");
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.push_back({0, 1, 4});
  EXPECT_THROW(write_mesh(file("a"), mesh, GetParam()), std::invalid_argument);
  EXPECT_THROW(write_mesh(file("a"), TriangleMesh{}, GetParam()), std::invalid_argument);
  EXPECT_EQ(bytes_of(file("a")), "old");
  EXPECT_THROW(write_mesh(file("missing/a"), tetrahedron(), GetParam()), FileError);
}

/// assimp's 3MF has six digits and its GLB is in metres; both follow further down.
TEST(OtherFormats, ReadsWhatAssimpWrites) {
  const TestFolder folder;
  const TriangleMesh mesh = torus(40, 12);
  const auto scene = assimp_scene(mesh, {0, 0, 0});
  for (const auto& [kind, name] : std::map<std::string, std::string>{
           {"stlb", "a.stl"}, {"objnomtl", "a.obj"}, {"plyb", "b.ply"}, {"ply", "text.ply"}}) {
    Assimp::Exporter exporter;
    ASSERT_EQ(exporter.Export(scene.get(), kind, (folder / name).string()), aiReturn_SUCCESS);
    if (kind != "ply") {
      expect_same_corners(read_mesh(folder / name), mesh);
    }
    EXPECT_EQ(read_mesh(folder / name).triangles.size(), mesh.triangles.size());
  }
}

TEST(StlFile, IsBinaryWithRightNormals) {
  const TestFolder folder;
  const TriangleMesh mesh = torus(40, 12);
  write_mesh(folder / "a.stl", mesh, MeshFormat::stl);
  const std::string bytes = bytes_of(folder / "a.stl");
  ASSERT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
  EXPECT_NE(bytes.substr(0, 5), "solid");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array<float, 12> facet;
    std::memcpy(facet.data(), bytes.data() + 84 + 50 * i, sizeof facet);
    const auto edge = [&](std::size_t to, std::size_t axis) {
      return double{facet[3 * to + axis]} - double{facet[3 + axis]};
    };
    double length = 0;
    double along_first = 0;
    double along_second = 0;
    double outward = 0;  // from the circle in the middle of the torus's body
    const double ring = std::hypot(facet[3], facet[4]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      length += facet[axis] * facet[axis];
      along_first += facet[axis] * edge(2, axis);
      along_second += facet[axis] * edge(3, axis);
      const double middle = axis == 2 ? 0 : 17 / ring * facet[3 + axis];
      outward += facet[axis] * (facet[3 + axis] - middle);
    }
    EXPECT_NEAR(length, 1, 1e-6);
    EXPECT_NEAR(along_first, 0, 3e-7);
    EXPECT_NEAR(along_second, 0, 3e-7);
    EXPECT_GT(outward, 0.8);
  }
}

TEST(StlFile, AFacetWithoutAreaHasNoNormal) {
  const TestFolder folder;
  write_mesh(folder / "a.stl", {{{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}}}, MeshFormat::stl);
  EXPECT_EQ(bytes_of(folder / "a.stl").substr(84, 12), std::string(12, '\0'));
}

TEST(StlFile, IsTextWhereAsked) {
  const TestFolder folder;
  write_mesh(folder / "my part-text.stl", {{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}},
             MeshFormat::stl_text);
  EXPECT_EQ(bytes_of(folder / "my part-text.stl"),
            "solid my_part-text\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
            "vertex 0 0.1 0\nendloop\nendfacet\nendsolid my_part-text\n");
}

TEST(StlFile, WeldsBackToTheSharedVertices) {
  const TestFolder folder;
  const TriangleMesh mesh = torus(40, 12);
  write_mesh(folder / "a.stl", mesh, MeshFormat::stl);
  const TriangleMesh read = read_mesh(folder / "a.stl");
  EXPECT_EQ(read.vertices.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(weld(read).vertices.size(), mesh.vertices.size());
}

TEST(StlFile, ReadsABinaryFileThatBeginsWithSolid) {
  const TestFolder folder;
  write_mesh(folder / "a.stl", tetrahedron(), MeshFormat::stl);
  std::string bytes = bytes_of(folder / "a.stl");
  bytes.replace(0, 5, "solid");
  put_bytes(folder / "a.STL", bytes);
  expect_same_corners(read_mesh(folder / "a.STL"), tetrahedron());
}

TEST(StlFile, ReadsTextWithSeveralSolids) {
  const TestFolder folder;
  const std::string facet =
      "facet normal 0 0 1\r\n outer loop\r\n  vertex 0 0 0.5\n  vertex 1.25 0 0.5\n"
      "  vertex 0 1e1 0.5\n endloop\nendfacet\n";
  put_bytes(folder / "a.stl",
            "solid one\n" + facet + facet + "endsolid one\nsolid two\n" + facet + "endsolid two\n");
  const TriangleMesh mesh = read_mesh(folder / "a.stl");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  const TriangleMesh welded = weld(mesh);
  EXPECT_EQ(welded.vertices, (std::vector<Point>{{0, 0, 0.5}, {1.25, 0, 0.5}, {0, 10, 0.5}}));
}

/// A facet whose corners are told apart by their x coordinates.
std::string text_facet() {
  return "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 2 0 0\nvertex 3 5 0\nendloop\n"
         "endfacet\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(StlFile, ReadsTheDialectsOfText) {
  const std::string plain = "solid box\n" + text_facet() + text_facet() + "endsolid box\n";
  std::string capitals = plain;
  for (char& c : capitals) {
    c = static_cast<char>(std::toupper(c));
  }
  const std::string one_line = replaced(plain, "\n", " ");
  const std::string two_words =
      replaced(replaced(replaced(plain, "endloop", "end loop"), "endfacet", "end facet"),
               "endsolid", "end solid");
  const std::vector<std::string> dialects{
      plain,
      capitals,
      one_line,
      replaced(one_line, "box", ""),
      two_words,
      replaced(two_words, "\n", "\r\n"),
      replaced(plain, "\n", "\r"),
      "\xEF\xBB\xBF" + plain,
      "# made by hand\n; on a Monday\n" + replaced(plain, "outer", "// a corner each\nouter"),
      replaced(plain, "box", "facet of a solid"),
      replaced(plain, "box", "C:\\parts\\"),
      replaced(plain, "normal 0 0 1", "normal -nan(ind) 1.#QNAN nan"),
      replaced(plain, "normal 0 0 1", ""),
      replaced(plain, "outer loop\nvertex", "outer\nloop\nvertex\n")};
  for (const std::string& text : dialects) {
    TriangleMesh mesh;
    ASSERT_NO_THROW(mesh = read_mesh_bytes("a.stl", text)) << text;
    ASSERT_EQ(mesh.triangles.size(), 2U) << text;
    EXPECT_EQ(mesh.vertices[5], (Point{3, 5, 0})) << text;
  }
  EXPECT_EQ(read_mesh_bytes("a.stl", one_line + one_line).triangles.size(), 4U);
  EXPECT_EQ(read_mesh_bytes("a.stl", plain + one_line + "\n" + plain).triangles.size(), 6U);
}

/// Bytes that name the order of the others: EF BB BF, which UTF-8 does not need.
TEST(TextFiles, MayBeginWithAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n";
  EXPECT_EQ(read_mesh_bytes("a.obj", mark + obj).vertices.size(), 4U);
  EXPECT_EQ(read_mesh_bytes("a.off", mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
                .triangles.size(),
            1U);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(read_mesh_bytes("a.ply", mark + ply).triangles.size(), 1U);
  EXPECT_EQ(read_mesh_bytes("a.ply", replaced(ply, "\n", "\r")).triangles.size(), 1U);
  EXPECT_EQ(read_mesh_bytes("a.obj", replaced(obj, "\n", "\r")).triangles.size(), 1U);
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
    for (const std::string other : {"\xFF\xFE", "\xFE\xFF"}) {
      try {
        read_mesh_bytes(name, other + std::string("v\0 \0", 4));
        ADD_FAILURE() << name;
      } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("UTF-16"), std::string::npos) << error.what();
      }
    }
  }
}

TEST(PartColour, IsInTheFormatsThatHaveOne) {
  const TestFolder folder;
  const MeshLook look{.colour = {0.2, 0.4, 1}};
  write_mesh(folder / "a.glb", tetrahedron(), MeshFormat::glb, look);
  write_mesh(folder / "a.3mf", tetrahedron(), MeshFormat::three_mf, look);
  const std::string glb = bytes_of(folder / "a.glb");
  const std::size_t at = glb.find("\"baseColorFactor\":[");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(glb.substr(at + 19)), std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-9);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "a.3mf").string(), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  aiColor4D seen;
  ASSERT_EQ(
      scene->mMaterials[scene->mMeshes[0]->mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, seen),
      aiReturn_SUCCESS);
  EXPECT_NEAR(seen.r, 51 / 255.0, 1e-6);
  EXPECT_NEAR(seen.g, 102 / 255.0, 1e-6);
  EXPECT_NEAR(seen.b, 1, 1e-6);
}

TEST(ObjFile, IsPlainText) {
  const TestFolder folder;
  write_mesh(folder / "a.obj", tetrahedron(), MeshFormat::obj);
  EXPECT_EQ(
      bytes_of(folder / "a.obj"),
      "# unit mm\no a\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_EQ(read_mesh(folder / "a.obj").triangles, tetrahedron().triangles);
  EXPECT_EQ(read_mesh(folder / "a.obj").vertices.size(), 4U);
}

TEST(ObjFile, ReadsWhatOtherProgramsWrite) {
  const TestFolder folder;
  put_bytes(folder / "a.obj",
            "# a square, then a triangle\r\nmtllib no.mtl\r\no part\r\nv 0 0 0 1.0\r\n"
            "v +1 0 0 0.5 0.5 0.5\r\nv 1 1 0 # third\r\n\tv 0 1e0 0\r\nvt 0 0\nvn 0 0 1\n"
            "usemtl red\ns off\nf 1/1/1 2/1/1 \\\n 3//1 4\nv 0.5 0.5 -1E-2\nf -1 -5 2 # last");
  const TriangleMesh mesh = read_mesh(folder / "a.obj");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 0, 1}}));
  ASSERT_EQ(mesh.vertices.size(), 5U);
  EXPECT_EQ(mesh.vertices[1], (Point{1, 0, 0}));
  EXPECT_EQ(mesh.vertices[4], (Point{0.5, 0.5, -0.01F}));
}

TEST(OtherFormats, AppliesTheNodesOfGlb) {
  const TestFolder folder;
  const auto scene = assimp_scene(torus(20, 8), {10, 20, 30});
  Assimp::Exporter exporter;
  ASSERT_EQ(exporter.Export(scene.get(), "glb2", (folder / "a.glb").string()), aiReturn_SUCCESS);
  TriangleMesh moved = torus(20, 8);
  for (Point& p : moved.vertices) {
    const Point metres{static_cast<float>(p[0]), static_cast<float>(p[1]),
                       static_cast<float>(p[2])};
    p = {1000 * (metres[0] + 10), -1000 * (metres[2] + 30), 1000 * (metres[1] + 20)};
  }
  const TriangleMesh read = read_mesh(folder / "a.glb");
  ASSERT_EQ(read.triangles, moved.triangles);
  for (std::size_t i = 0; i < moved.vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(read.vertices[i][axis], moved.vertices[i][axis]);
    }
  }
}

TEST(OtherFormats, Reads3mfOfAssimp) {
  const TestFolder folder;
  const auto scene = assimp_scene(tetrahedron(), {0, 0, 0});
  Assimp::Exporter exporter;
  ASSERT_EQ(exporter.Export(scene.get(), "3mf", (folder / "a.3mf").string()), aiReturn_SUCCESS);
  expect_same_corners(read_mesh(folder / "a.3mf"), tetrahedron());
}

}  // namespace
}  // namespace latticast
