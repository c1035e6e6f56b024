// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/three_mf_file.h"

#include <memory>
#include <random>

#include <Model/COM/NMR_DLLInterfaces.h>
#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "export/mesh/zip_archive.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/example_meshes.h"
#include "tests/unit/export/mesh/three_mf_packages.h"
#include "tests/unit/export/test_folder.h"

// lib3mf does not free all that it takes from libzip; its own frame is in the stack only when that
// is unwound with care. (The sanitizers ask for these names.)
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:lib3MF";
}

extern "C" const char* __asan_default_options() {
  return "fast_unwind_on_malloc=0";
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace latticast {
namespace {

// --- What the 3MF consortium's own library sees
// ---------------------------------------------------

struct Release {
  void operator()(NMR::PLib3MFBase* object) const { NMR::lib3mf_release(object); }
};
using Held = std::unique_ptr<NMR::PLib3MFBase, Release>;

void expect_done(LIB3MFRESULT result) {
  ASSERT_EQ(result, LIB3MF_OK);
}

std::vector<NamedMesh> parts_of(NMR::PLib3MFModel* model) {
  std::vector<NamedMesh> parts;
  NMR::PLib3MFModelResourceIterator* objects = nullptr;
  expect_done(NMR::lib3mf_model_getmeshobjects(model, &objects));
  const Held held_objects(objects);
  for (BOOL more = 1; NMR::lib3mf_resourceiterator_movenext(objects, &more) == LIB3MF_OK && more;) {
    NMR::PLib3MFModelResource* object = nullptr;
    expect_done(NMR::lib3mf_resourceiterator_getcurrent(objects, &object));
    const Held held(object);
    NamedMesh part;
    std::array<char, 200> name{};
    ULONG size = 0;
    expect_done(NMR::lib3mf_object_getnameutf8(object, name.data(), name.size(), &size));
    part.name = name.data();
    DWORD count = 0;
    expect_done(NMR::lib3mf_meshobject_getvertexcount(object, &count));
    for (DWORD i = 0; i < count; ++i) {
      NMR::MODELMESHVERTEX vertex;
      expect_done(NMR::lib3mf_meshobject_getvertex(object, i, &vertex));
      part.mesh.vertices.push_back(
          {vertex.m_fPosition[0], vertex.m_fPosition[1], vertex.m_fPosition[2]});
    }
    expect_done(NMR::lib3mf_meshobject_gettrianglecount(object, &count));
    for (DWORD i = 0; i < count; ++i) {
      NMR::MODELMESHTRIANGLE triangle;
      expect_done(NMR::lib3mf_meshobject_gettriangle(object, i, &triangle));
      part.mesh.triangles.push_back(
          {triangle.m_nIndices[0], triangle.m_nIndices[1], triangle.m_nIndices[2]});
    }
    parts.push_back(part);
  }
  return parts;
}

/// Read strictly: a warning counts as a failure. Checks the unit and the number of build items.
std::vector<NamedMesh> read_by_lib3mf(const std::filesystem::path& file) {
  NMR::PLib3MFModel* model = nullptr;
  expect_done(NMR::lib3mf_createmodel(&model));
  const Held held_model(model);
  NMR::PLib3MFModelReader* reader = nullptr;
  expect_done(NMR::lib3mf_model_queryreader(model, "3mf", &reader));
  const Held held_reader(reader);
  expect_done(NMR::lib3mf_reader_setstrictmodeactive(reader, 1));
  expect_done(NMR::lib3mf_reader_readfromfileutf8(reader, file.c_str()));
  DWORD warnings = 0;
  expect_done(NMR::lib3mf_reader_getwarningcount(reader, &warnings));
  EXPECT_EQ(warnings, 0U);
  DWORD unit = 0;
  expect_done(NMR::lib3mf_model_getunit(model, &unit));
  EXPECT_EQ(unit, static_cast<DWORD>(NMR::MODELUNIT_MILLIMETER));
  std::vector<NamedMesh> parts = parts_of(model);
  NMR::PLib3MFModelBuildItemIterator* items = nullptr;
  expect_done(NMR::lib3mf_model_getbuilditems(model, &items));
  const Held held_items(items);
  std::size_t count = 0;
  for (BOOL more = 1; NMR::lib3mf_builditemiterator_movenext(items, &more) == LIB3MF_OK && more;) {
    ++count;
  }
  EXPECT_EQ(count, parts.size());
  return parts;
}

TEST(ThreeMfFile, TheConsortiumsLibrarySeesTheSameParts) {
  const TestFolder folder;
  const std::vector<NamedMesh> parts{{"segment-1-lattice", torus(40, 12), {1, 0.5, 0}},
                                     {"Dübel <\"a\" & 'b'> 部 🙂", tetrahedron(), {0, 0, 1}},
                                     {"", torus(5, 4)}};
  write_three_mf(folder / "a.3mf", parts);
  const std::vector<NamedMesh> seen = read_by_lib3mf(folder / "a.3mf");
  ASSERT_EQ(seen.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(seen[i].name, parts[i].name);
    expect_same_mesh(seen[i].mesh, parts[i].mesh);
  }
}

// lib3mf takes coordinates up to 1e9 mm.
TEST(ThreeMfFile, TheConsortiumsLibrarySeesEveryBit) {
  const TestFolder folder;
  constexpr unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-30, 8.9);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    Point point;
    for (double& x : point) {
      x = (random() % 2 == 0 ? 1 : -1) * std::pow(10, exponent(random));
    }
    mesh.vertices.push_back(point);
    if (i % 3 == 2) {
      mesh.triangles.push_back({i, i - 1, i - 2});
    }
  }
  write_mesh(folder / "part.3mf", mesh, MeshFormat::three_mf);
  const std::vector<NamedMesh> seen = read_by_lib3mf(folder / "part.3mf");
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].name, "part");
  expect_same_mesh(seen[0].mesh, mesh);
}

TEST(ThreeMfFile, ReadsAllPartsInOrder) {
  const std::vector<NamedMesh> parts{{"a", tetrahedron()}, {"b", hard_mesh()}};
  TriangleMesh both = tetrahedron();
  for (const Point& vertex : hard_mesh().vertices) {
    both.vertices.push_back(vertex);
  }
  for (const Triangle& t : hard_mesh().triangles) {
    both.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  }
  expect_same_mesh(joined(decode_three_mf("a.3mf", encode_three_mf(parts))), both);
}

TEST(ThreeMfFile, RefusesWhatItCannotHold) {
  const TestFolder folder;
  put_bytes(folder / "a.3mf", "old");
  const auto refuses = [&](const NamedMesh& part) {
    EXPECT_THROW(write_three_mf(folder / "a.3mf", std::array{part}), std::invalid_argument);
  };
  TriangleMesh mesh = tetrahedron();
  mesh.vertices[2][1] = 1e39;
  refuses({"a", mesh});
  mesh = tetrahedron();
  mesh.triangles[1][1] = 4;
  refuses({"a", mesh});
  refuses({"a", {}});
  for (const std::string name :
       {"\xff", "a\x01", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xe0\x80\x80", "\xf4\x90\x80\x80",
        "\xf0\x80\x80\x80", "a\xe2\x82", "\xef\xbf\xbf", "\n"}) {
    refuses({name, tetrahedron()});
  }
  EXPECT_THROW(write_three_mf(folder / "a.3mf", {}), std::invalid_argument);
  EXPECT_EQ(bytes_of(folder / "a.3mf"), "old");
}

// --- Files of other programs --------------------------------------------------------------------

TriangleMesh read(const std::string& resources, const std::string& build,
                  const std::string& attributes = "") {
  return joined(decode_three_mf("a.3mf", package(model_of(resources, build, attributes))));
}

std::string complaint(const std::string& bytes) {
  try {
    const TriangleMesh mesh = joined(decode_three_mf("a.3mf", bytes));
    for (const Triangle& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        EXPECT_LT(corner, mesh.vertices.size());
      }
    }
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST(ThreeMfReader, AppliesTheUnit) {
  const std::vector<std::pair<std::string, double>> units{{"", 1},
                                                          {"unit=\"millimeter\"", 1},
                                                          {"unit=\"micron\"", 0.001},
                                                          {"unit=\"centimeter\"", 10},
                                                          {"unit=\"inch\"", 25.4},
                                                          {"unit=\"foot\"", 304.8},
                                                          {"unit=\"meter\"", 1000}};
  for (const auto& [attribute, mm] : units) {
    expect_same_mesh(
        read(triangle_object, "<c:item objectid=\"1\"/>", attribute),
        {{{mm, 2 * mm, 3 * mm}, {4 * mm, 2 * mm, 3 * mm}, {mm, 5 * mm, 3 * mm}}, {{0, 1, 2}}});
  }
}

TEST(ThreeMfReader, PlacesItemsAndComponents) {
  // Row vectors: (x, y, z, 1) times the 4 x 3 matrix. A quarter turn about z, then (10, 20, 30).
  const std::string turn = "transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"";
  const std::string mirror = "transform=\"-1 0 0  0 1 0  0 0 1  0 0 0\"";
  const TriangleMesh mesh =
      read(triangle_object +
               "<c:object id=\"2\"><c:components><c:component objectid=\"1\"/><c:component "
               "objectid=\"1\" " +
               mirror + "/></c:components></c:object>",
           "<c:item objectid=\"2\" " + turn + "/><c:item objectid=\"1\"/>");
  expect_same_mesh(mesh, {{{8, 21, 33},
                           {8, 24, 33},
                           {5, 21, 33},
                           {8, 19, 33},
                           {8, 16, 33},
                           {5, 19, 33},
                           {1, 2, 3},
                           {4, 2, 3},
                           {1, 5, 3}},
                          {{0, 1, 2}, {3, 5, 4}, {6, 7, 8}}});
}

TEST(ThreeMfReader, SaysWhatIsWrong) {
  const std::string item = "<c:item objectid=\"1\"/>";
  const auto said = [&](const std::string& from, const std::string& to) {
    std::string object = triangle_object;
    return complaint(package(model_of(object.replace(object.find(from), from.size(), to), item)));
  };
  const std::vector<std::tuple<std::string, std::string, std::string>> cases{
      {"v3=\"2\"", "v3=\"3\"", "there is no vertex 3"},
      {"v3=\"2\"", "v3=\"-1\"", "\"-1\" is no index"},
      {"v3=\"2\"", "", "the attribute v3 is missing"},
      {"x=\"4\"", "x=\"4,5\"", "\"4,5\" is no number"},
      {"y=\"5\"", "y=\"\"", "\"\" is no number"},
      {"z=\"3\"", "", "the attribute z is missing"},
      {"id=\"1\"", "id=\"2\"", "there is no object 1"},
      {"</c:mesh>", "", "mismatched tag"},
      {"<c:mesh>", "<c:mesh>&lol;", "undefined entity"}};
  for (const auto& [from, to, reason] : cases) {
    EXPECT_NE(said(from, to).find(reason), std::string::npos) << reason << ": " << said(from, to);
  }
  const std::vector<std::tuple<std::string, std::string, std::string>> models{
      {triangle_object + triangle_object, item, "a second object 1"},
      {triangle_object, "<c:item objectid=\"1\" p:path=\"/3D/b.model\"/>",
       "no object 1 in \"/3D/b.model\""},
      {triangle_object, "<c:item objectid=\"1\" transform=\"1 0 0\"/>", "twelve numbers"},
      {triangle_object, "<c:vertex x=\"1\" y=\"1\" z=\"1\"/>", "outside of an object"},
      {"<c:object id=\"1\"><c:components><c:component objectid=\"1\"/></c:components></c:object>",
       item, "there is no object 1 before it"}};
  for (const auto& [resources, build, reason] : models) {
    const std::string words = complaint(package(model_of(resources, build)));
    EXPECT_NE(words.find(reason), std::string::npos) << words;
  }
  EXPECT_NE(complaint(package(model_of("", "", "unit=\"yard\""))).find("no unit"),
            std::string::npos);
  EXPECT_NE(complaint(package("<!DOCTYPE a [<!ENTITY b \"c\">]>" + model_of(triangle_object, item)))
                .find("document type"),
            std::string::npos);
  EXPECT_NE(complaint(package("", "/none.model")).find("no readable \"none.model\""),
            std::string::npos);
  EXPECT_NE(complaint(zip(std::array<ZipEntry, 1>{{{"a", "b"}}})).find("_rels"), std::string::npos);
}

TEST(ThreeMfReader, ComponentsMayNotMultiplyBeyondReason) {
  std::string resources = triangle_object;
  for (int i = 2; i < 60; ++i) {
    const std::string use = "<c:component objectid=\"" + std::to_string(i - 1) + "\"/>";
    resources += "<c:object id=\"" + std::to_string(i) + "\"><c:components>" + use + use +
                 "</c:components></c:object>";
  }
  EXPECT_NE(
      complaint(package(model_of(resources, "<c:item objectid=\"59\"/>"))).find("too many times"),
      std::string::npos);
}

TEST(ThreeMfReader, CutAnywhere) {
  const std::string bytes = encode_three_mf(std::array{NamedMesh{"a", torus(12, 6)}});
  ASSERT_EQ(complaint(bytes), "");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(complaint(bytes.substr(0, size)), "") << size;
  }
}

TEST(ThreeMfReader, RandomDamageNeverCrashes) {
  constexpr unsigned seed = 72;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::string archive = encode_three_mf(std::array{NamedMesh{"a", torus(6, 5)}});
  const std::string model = model_of(triangle_object, "<c:item objectid=\"1\"/>");
  for (int trial = 0; trial < 1000; ++trial) {
    std::string bytes = archive;
    std::string text = model;
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
      const std::size_t at = random() % text.size();
      text.replace(at, random() % 10, model, random() % model.size(), random() % 20);
    }
    complaint(bytes);
    complaint(package(text));
  }
}

}  // namespace
}  // namespace latticast
