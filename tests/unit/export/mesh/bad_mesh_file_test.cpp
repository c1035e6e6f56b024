// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "tests/unit/export/mesh/example_meshes.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

const std::string text_stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid";

const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

/// What `read` says against a file, or "" when it gives a mesh.
template <typename Read>
std::string complaint_of(const std::filesystem::path& file, Read read) {
  try {
    const TriangleMesh mesh = read();
    for (const Triangle& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        EXPECT_LT(corner, mesh.vertices.size());
      }
    }
    return "";
  } catch (const FileError& error) {
    EXPECT_EQ(error.path, file);
    return error.what();
  }
}

std::string complaint(const std::string& name, const std::string& bytes) {
  return complaint_of(name, [&] { return read_mesh_bytes(name, bytes); });
}

std::string complaint(const std::filesystem::path& file) {
  return complaint_of(file, [&] { return read_mesh(file); });
}

class BadMeshFile : public testing::Test {
 protected:
  std::string written(const std::string& name, MeshFormat format) {
    write_mesh(folder_ / name, torus(6, 5), format);
    return bytes_of(folder_ / name);
  }

  TestFolder folder_;
};

bool says(const std::string& complaint, const std::string& words) {
  return complaint.find(words) != std::string::npos;
}

TEST_F(BadMeshFile, MissingFolderOrDevice) {
  EXPECT_TRUE(says(complaint(folder_ / "none.stl"), "does not exist"));
  std::filesystem::create_directory(folder_ / "folder.stl");
  EXPECT_TRUE(says(complaint(folder_ / "folder.stl"), "is a folder"));
  EXPECT_TRUE(says(complaint(std::filesystem::path("/dev/zero")), "not a regular file"));
}

TEST_F(BadMeshFile, EmptyOrGarbageInEveryFormat) {
  std::string garbage(5000, '\0');
  std::mt19937 random(7);
  for (char& c : garbage) {
    c = static_cast<char>(random());
  }
  for (const MeshFormatName& known : mesh_format_names) {
    const std::string extension(known.suffix);
    EXPECT_TRUE(says(complaint("a" + extension, ""), "is empty")) << extension;
    EXPECT_NE(complaint("b" + extension, garbage), "") << extension;
    EXPECT_NE(complaint("c" + extension, "solid"), "") << extension;
    EXPECT_NE(complaint("d" + extension, "\n"), "") << extension;
  }
  EXPECT_TRUE(says(complaint("a.txt", "v 0 0 0"), "extension"));
  EXPECT_TRUE(says(complaint("stl", text_stl), "extension"));
}

TEST_F(BadMeshFile, StlCutAnywhere) {
  const std::string bytes = written("a.stl", MeshFormat::stl);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(complaint("cut.stl", bytes.substr(0, size)), "") << size;
  }
}

TEST_F(BadMeshFile, StlWithAnotherCountThanItHolds) {
  std::string bytes = written("a.stl", MeshFormat::stl);
  for (const std::uint32_t count : {0U, 59U, 61U, 0x7fffffffU, 0xffffffffU}) {
    std::memcpy(bytes.data() + 80, &count, 4);
    EXPECT_TRUE(says(complaint("b.stl", bytes), std::to_string(count) + " triangles")) << count;
  }
  EXPECT_TRUE(says(complaint("none.stl", std::string(84, '\0')), "holds no triangle"));
}

TEST_F(BadMeshFile, TextStlCutAnywhere) {
  EXPECT_EQ(complaint("a.stl", text_stl), "");
  for (std::size_t size = 0; size < text_stl.size(); ++size) {
    EXPECT_NE(complaint("cut.stl", text_stl.substr(0, size)), "") << size;
  }
}

TEST_F(BadMeshFile, TextStlNamesTheLine) {
  std::string text = text_stl;
  text.replace(text.find("vertex 1 0 0"), 12, "vertex 1 zero");
  EXPECT_TRUE(says(complaint("a.stl", text), "line 5: a vertex needs three numbers"));
  text = text_stl;
  text.erase(text.find("vertex 1 1 0"), 13);
  EXPECT_TRUE(says(complaint("a.stl", text), "line 14: a facet needs three vertices"));
  text = text_stl;
  text.insert(text.find("endloop"), "vertex 5 5 5\n");
  EXPECT_TRUE(says(complaint("a.stl", text), "line 9: a facet needs three vertices"));
  text = text_stl;
  text.replace(text.find("endfacet"), 8, "endfacte");
  EXPECT_TRUE(says(complaint("a.stl", text), "line 8: \"endfacte\" is no statement"));
  EXPECT_TRUE(says(complaint("a.stl", "solid a\nendsolid\nfacet\n"), "line 3: is out of place"));
}

TEST_F(BadMeshFile, TextThatIsNoStlIsNotSaidToBeABinaryOne) {
  for (const std::string& text :
       {text_stl.substr(8), std::string("v 0 0 0\n"), std::string(500, 'x')}) {
    EXPECT_TRUE(says(complaint("a.stl", text), "neither text STL")) << complaint("a.stl", text);
  }
}

TEST_F(BadMeshFile, LongWordsAreNotRepeatedWhole) {
  const std::string word(1000000, 'x');
  EXPECT_LT(complaint("a.obj", "v 0 0 0\nf 1 1 " + word).size(), 200U);
  EXPECT_LT(complaint("a.stl", "solid a\n" + word).size(), 200U);
  EXPECT_LT(complaint("a.off", word).size(), 200U);
  EXPECT_LT(complaint("a.ply", "ply\n" + word + "\n").size(), 200U);
  EXPECT_LT(complaint("a.ply", ply_header + "0 0 " + word).size(), 200U);
}

TEST_F(BadMeshFile, ObjNamesTheLine) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(says(complaint("a.obj", corners + "f 1 2 4\n"), "line 4: there is no vertex 4"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "f 0 1 2\n"), "line 4: there is no vertex 0"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "f 1 2 -4\n"), "line 4: there is no vertex -4"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "\nf 1 2\n"), "line 5: a face needs three"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "f\n"), "line 4: a face needs three"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "f 1 2 x\n"), "\"x\" is not a vertex number"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "f 1 2 99999999999999999999\n"), "not a vertex"));
  EXPECT_TRUE(says(complaint("a.obj", "v 1 \\\n 2\nf 1 1 1\n"), "line 2: a vertex needs three"));
  EXPECT_TRUE(says(complaint("a.obj", "v 1 2 3x\n"), "line 1: a vertex needs three"));
  EXPECT_TRUE(says(complaint("a.obj", "v 1 2 +\n"), "line 1: a vertex needs three"));
  EXPECT_TRUE(says(complaint("a.obj", corners + "p 1\nl 1 2\n"), "holds no triangle"));
}

TEST_F(BadMeshFile, PlyNamesWhatIsWrong) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  const auto header_with = [](const std::string& from, const std::string& to) {
    std::string header = ply_header;
    return header.replace(header.find(from), from.size(), to);
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {ply_header + corners + "3 0 1 3\n", "face 0: there is no vertex 3"},
      {ply_header + corners + "3 0 1 -1\n", "face 0: there is no vertex -1"},
      {ply_header + corners + "2 0 1\n", "face 0: a face needs three vertices"},
      {ply_header + corners + "-3 0 1 2\n", "face 0: a list of -3 values"},
      {ply_header + corners + "3 0 1\n", "face 0: the file ends in it"},
      {ply_header + corners + "3 0 1 2.5\n", "face 0: \"2.5\" is no integer"},
      {ply_header + corners + "3 0 1 2 7\n", "goes on after the last element"},
      {ply_header + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2", "vertex 1: \"zero\" is no number"},
      {header_with("vertex 3", "vertex 4000000000") + corners, "more \"vertex\" elements"},
      {header_with("vertex 3", "vertex three") + corners, "line 3: \"three\" is no count"},
      {header_with("vertex 3", "vertex -3") + corners, "line 3: \"-3\" is no count"},
      {header_with("property float z", "property float w") + corners, "without numbers x, y and z"},
      {header_with("property float z", "property float x") + corners, "a second property \"x\""},
      {header_with("property float z", "property real z") + corners, "line 6: \"real\" is no type"},
      {header_with("list uchar", "list float"), "line 8: the length of a list must be an integer"},
      {header_with("element face", "element vertex"), "line 7: a second element \"vertex\""},
      {header_with("element", "elemant"), "line 3: \"elemant\" is no statement"},
      {header_with("format ascii 1.0\n", ""), "the format is missing"},
      {header_with("ascii 1.0", "ascii 2.0"), "line 2: is no format"},
      {header_with("format ascii 1.0\n", "property float x\n"), "before the first element"},
      {header_with("vertex_indices", "corners") + corners + "3 0 1 2\n", "holds no triangle"},
      {"ply\nelement vertex 3\n", "a PLY header without an end"},
      {"plyx\n", "does not begin with a PLY header"}};
  for (const auto& [bytes, reason] : cases) {
    EXPECT_TRUE(says(complaint("a.ply", bytes), reason)) << reason << "\n"
                                                         << bytes << "\n"
                                                         << complaint("a.ply", bytes);
  }
  EXPECT_EQ(complaint("a.ply", ply_header + corners + "3 0 1 2\n"), "");
}

TEST_F(BadMeshFile, PlyCutAnywhere) {
  const std::string bytes = written("a.ply", MeshFormat::ply);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(complaint("cut.ply", bytes.substr(0, size)), "") << size;
  }
  EXPECT_TRUE(says(complaint("long.ply", bytes + '\0'), "goes on after the last element"));
}

/// Whatever is done to a file, reading it gives a mesh with valid indices or a FileError.
TEST_F(BadMeshFile, RandomDamageNeverCrashes) {
  const std::vector<std::pair<std::string, std::string>> originals{
      {"a.stl", written("a.stl", MeshFormat::stl)},
      {"a.obj", written("a.obj", MeshFormat::obj)},
      {"a.ply", written("a.ply", MeshFormat::ply)},
      {"text.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"text.stl", text_stl}};
  constexpr unsigned seed = 20240611;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto& [name, original] = originals[random() % originals.size()];
    std::string bytes = original;
    for (std::size_t changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % bytes.size();
      switch (random() % 3) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes.erase(at, 1 + random() % 20);
          break;
        default:
          bytes.insert(at, original, random() % original.size(), random() % 40);
      }
      if (bytes.empty()) {
        bytes = "x";
      }
    }
    complaint(name, bytes);
  }
}

}  // namespace
}  // namespace latticast
