// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/glb_file.h"

#include <cstring>
#include <random>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "design/file_error.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/example_meshes.h"
#include "tests/unit/export/mesh/glb_bytes.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

std::uint32_t uint32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// A GLB file taken apart by the book: a 12-byte header, a JSON chunk, a binary chunk.
struct Parts {
  explicit Parts(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(uint32_at(bytes, 4), 2U);
    EXPECT_EQ(uint32_at(bytes, 8), bytes.size());
    const std::size_t length = uint32_at(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = Json::parse(bytes.substr(20, length));
    EXPECT_EQ(length % 4, 0U);
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    EXPECT_EQ(uint32_at(bytes, 20 + length), bytes.size() - 28 - length);
    EXPECT_EQ(bytes.size() % 4, 0U);
    data = bytes.substr(28 + length);
  }

  std::vector<float> floats(const Json& number) const {
    const Json& accessor = json["accessors"][number.get<std::size_t>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    std::vector<float> values(accessor["count"].get<std::size_t>() *
                              (accessor["type"] == "VEC3" ? 3 : 1));
    EXPECT_EQ(view["byteLength"], 4 * values.size());
    std::memcpy(values.data(), data.data() + view.value("byteOffset", 0), 4 * values.size());
    return values;
  }

  Json json;
  std::string data;
};

std::vector<Point> lifted(std::vector<Point> points, double height) {
  for (Point& point : points) {
    point[2] += height * point[0];
  }
  return points;
}

/// Two bodies that inflate, with different states, and one that does not.
Scene example_scene(bool animated) {
  const TriangleMesh ring = torus(8, 5);
  const TriangleMesh small = tetrahedron();
  return {{{"segment-1-lattice",
            ring,
            {1, 0.5, 0},
            {{"20", lifted(ring.vertices, 0.1)}, {"40", lifted(ring.vertices, 0.3)}}},
           {"segment-1-liner",
            small,
            {0, 0, 1},
            {{"20", small.vertices}, {"\"ü<&", lifted(small.vertices, -1)}}},
           {"clamp", small, {}}},
          animated};
}

TriangleMesh read(const std::string& bytes) {
  return joined(decode_glb("a.glb", bytes));
}

std::string complaint(const std::string& bytes) {
  try {
    const TriangleMesh mesh = read(bytes);
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

TEST(GlbFile, ComesBackBitForBitAndNumberedAlike) {
  for (const TriangleMesh& mesh : {hard_mesh(), torus(97, 31), tetrahedron()}) {
    expect_same_mesh(read(encode_glb({{{"part", mesh}}})), mesh);
  }
}

TEST(GlbFile, TurnsMillimetresIntoMetresWithYUpward) {
  const Parts parts(encode_glb(example_scene(false)));
  const Json& nodes = parts.json["nodes"];
  EXPECT_EQ(parts.json["scenes"][parts.json["scene"].get<int>()]["nodes"], Json({0}));
  EXPECT_EQ(nodes[0]["name"], "actuator");
  EXPECT_EQ(nodes[0]["children"], Json({1, 2, 3}));
  EXPECT_EQ(nodes[0]["matrix"].dump(),
            "[0.001,0.0,0.0,0.0,0.0,0.0,-0.001,0.0,0.0,0.001,0.0,0.0,0.0,0.0,0.0,1.0]");
  EXPECT_EQ(nodes[1]["name"], "segment-1-lattice");
  EXPECT_EQ(nodes[3]["name"], "clamp");
  EXPECT_EQ(parts.json["asset"]["version"], "2.0");
  EXPECT_TRUE(parts.json["asset"]["generator"].get<std::string>().starts_with("latticast "));
}

TEST(GlbFile, ADullSurfaceOfTheColourInLinearLight) {
  const Parts parts(encode_glb(example_scene(false)));
  const Json& material = parts.json["materials"][0];
  const Json& surface = material["pbrMetallicRoughness"];
  EXPECT_EQ(surface.value("metallicFactor", 1.0), 0);
  EXPECT_EQ(surface.value("roughnessFactor", 1.0), 0.6);
  EXPECT_FALSE(material.value("doubleSided", false));
  EXPECT_EQ(surface["baseColorFactor"][0], 1);
  EXPECT_NEAR(surface["baseColorFactor"][1], 0.21404114, 1e-8);  // sRGB 0.5
  EXPECT_EQ(surface["baseColorFactor"][2], 0);
  EXPECT_EQ(parts.json["materials"][2].value("pbrMetallicRoughness", Json())["baseColorFactor"],
            Json({0.0, 0.0, 0.0, 1.0}));
}

TEST(GlbFile, TargetsAreDifferencesWithNamesAndBounds) {
  const Scene scene = example_scene(false);
  const Parts parts(encode_glb(scene));
  EXPECT_FALSE(parts.json.contains("animations"));
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    const Json& mesh = parts.json["meshes"][body];
    const Json& primitive = mesh["primitives"][0];
    EXPECT_FALSE(primitive["attributes"].contains("NORMAL"));
    const std::vector<float> rest = parts.floats(primitive["attributes"]["POSITION"]);
    const auto& targets = scene.bodies[body].targets;
    EXPECT_EQ(primitive.contains("targets"), !targets.empty());
    for (std::size_t i = 0; i < targets.size(); ++i) {
      EXPECT_EQ(mesh["extras"]["targetNames"][i], targets[i].name);
      EXPECT_EQ(mesh["weights"][i], 0);
      const Json& accessor = primitive["targets"][i]["POSITION"];
      const std::vector<float> moves = parts.floats(accessor);
      ASSERT_EQ(moves.size(), rest.size());
      Point low{1e9, 1e9, 1e9};
      Point high{-1e9, -1e9, -1e9};
      for (std::size_t j = 0; j < moves.size(); ++j) {
        EXPECT_NEAR(double{rest[j]} + double{moves[j]}, targets[i].positions[j / 3][j % 3], 5e-7);
        low[j % 3] = std::min<double>(low[j % 3], moves[j]);
        high[j % 3] = std::max<double>(high[j % 3], moves[j]);
      }
      EXPECT_EQ(parts.json["accessors"][accessor.get<int>()]["min"], Json(low));
      EXPECT_EQ(parts.json["accessors"][accessor.get<int>()]["max"], Json(high));
    }
  }
}

TEST(GlbFile, KeyframesShowOneTargetEach) {
  const Parts parts(encode_glb(example_scene(true)));
  ASSERT_EQ(parts.json["animations"].size(), 1U);
  const Json& animation = parts.json["animations"][0];
  EXPECT_EQ(animation["name"], "inflate");
  ASSERT_EQ(animation["channels"].size(), 2U);
  const std::vector<float> times{0, 1, 2, 3, 4};
  const std::vector<float> weights{0, 0, 1, 0, 0, 1, 1, 0, 0, 0};
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& channel = animation["channels"][i];
    EXPECT_EQ(channel["target"], Json({{"node", i + 1}, {"path", "weights"}}));
    const Json& sampler = animation["samplers"][channel["sampler"].get<int>()];
    // With STEP, ParaView never shows the last state.
    EXPECT_EQ(sampler.value("interpolation", "LINEAR"), "LINEAR");
    EXPECT_EQ(parts.floats(sampler["input"]), times);
    EXPECT_EQ(parts.floats(sampler["output"]), weights);
    EXPECT_EQ(parts.json["accessors"][sampler["input"].get<int>()]["max"], Json({times.back()}));
  }
}

// A preview at 0 kPa shows what is there without it.
TEST(GlbFile, StatesAtRestAreNoTargets) {
  const TriangleMesh ring = torus(8, 5);
  Scene scene{{{"a",
                ring,
                {},
                {{"-2", lifted(ring.vertices, -0.1)},
                 {"0", ring.vertices},
                 {"2", lifted(ring.vertices, 0.1)}}}},
              true};
  const Parts parts(encode_glb(scene));
  EXPECT_EQ(parts.json["meshes"][0]["extras"]["targetNames"], Json({"-2", "2"}));
  const Json& sampler = parts.json["animations"][0]["samplers"][0];
  EXPECT_EQ(parts.floats(sampler["input"]), (std::vector<float>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(parts.floats(sampler["output"]),
            (std::vector<float>{0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}));
  scene.bodies[0].targets = {{"0", ring.vertices}};
  const Parts still(encode_glb(scene));
  EXPECT_FALSE(still.json.contains("animations"));
  EXPECT_FALSE(still.json["meshes"][0].contains("weights"));
}

TEST(GlbFile, AnimatesNoBodiesWithDifferentNumbersOfStates) {
  Scene scene = example_scene(true);
  scene.bodies[1].targets.pop_back();
  EXPECT_THROW(encode_glb(scene), std::invalid_argument);
}

TEST(GlbFile, WithoutTargetsThereIsNoAnimation) {
  EXPECT_FALSE(Parts(encode_glb({{{"a", tetrahedron()}}, true})).json.contains("animations"));
}

TEST(GlbFile, AssimpSeesTheSameMeshAndTargets) {
  const Scene scene = example_scene(true);
  const std::string bytes = encode_glb(scene);
  Assimp::Importer importer;
  const aiScene* seen = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
  ASSERT_NE(seen, nullptr) << importer.GetErrorString();
  ASSERT_EQ(seen->mNumMeshes, 3U);
  for (unsigned i = 0; i < 3; ++i) {
    const TriangleMesh& mesh = scene.bodies[i].mesh;
    const aiMesh& read_mesh = *seen->mMeshes[i];
    ASSERT_EQ(read_mesh.mNumVertices, mesh.vertices.size());
    ASSERT_EQ(read_mesh.mNumFaces, mesh.triangles.size());
    EXPECT_EQ(read_mesh.mNumAnimMeshes, scene.bodies[i].targets.size());
    for (unsigned j = 0; j < read_mesh.mNumVertices; ++j) {
      EXPECT_EQ(bits(read_mesh.mVertices[j].x), bits(mesh.vertices[j][0]));
      EXPECT_EQ(bits(read_mesh.mVertices[j].y), bits(mesh.vertices[j][1]));
      EXPECT_EQ(bits(read_mesh.mVertices[j].z), bits(mesh.vertices[j][2]));
    }
    for (unsigned j = 0; j < read_mesh.mNumFaces; ++j) {
      EXPECT_TRUE(std::equal(mesh.triangles[j].begin(), mesh.triangles[j].end(),
                             read_mesh.mFaces[j].mIndices));
    }
  }
}

TEST(GlbFile, BytesDependOnTheSceneAlone) {
  EXPECT_EQ(encode_glb(example_scene(true)), encode_glb(example_scene(true)));
  const TestFolder folder;
  write_glb(folder / "a.glb", example_scene(true));
  EXPECT_EQ(bytes_of(folder / "a.glb"), encode_glb(example_scene(true)));
}

TEST(GlbFile, RefusesWhatItCannotHold) {
  const TestFolder folder;
  put_bytes(folder / "a.glb", "old");
  Scene scene = example_scene(true);
  scene.bodies[0].targets[1].positions.pop_back();
  EXPECT_THROW(write_glb(folder / "a.glb", scene), std::invalid_argument);
  scene = example_scene(true);
  scene.bodies[0].targets[1].positions[3][1] = 1e39;
  EXPECT_THROW(encode_glb(scene), std::invalid_argument);
  scene = example_scene(true);
  scene.bodies[2].mesh.vertices[0][0] = std::nan("");
  EXPECT_THROW(encode_glb(scene), std::invalid_argument);
  scene = example_scene(true);
  scene.bodies[1].mesh.triangles[0][0] = 4;
  EXPECT_THROW(encode_glb(scene), std::invalid_argument);
  scene = example_scene(true);
  scene.bodies[1].name = "\xff";
  EXPECT_THROW(encode_glb(scene), std::invalid_argument);
  EXPECT_THROW(encode_glb({}), std::invalid_argument);
  EXPECT_EQ(bytes_of(folder / "a.glb"), "old");
}

// --- Files of other programs --------------------------------------------------------------------

TEST(GlbReader, GivesMillimetresWithZUpward) {
  expect_same_mesh(read(glb(triangle_json(), three_points())),
                   {{{1000, -3000, 2000}, {4000, -3000, 2000}, {1000, -3000, 5000}}, {{0, 1, 2}}});
}

TEST(GlbReader, PlacesNodesInTheirOrder) {
  Json json = triangle_json();
  const double half = std::sqrt(0.5);
  json["nodes"] = {{{"mesh", 0}, {"children", {2}}, {"translation", {1, 0, 0}}},
                   {{"mesh", 0}, {"scale", {-2, 1, 1}}},
                   {{"mesh", 0}, {"rotation", {0, half, 0, half}}, {"scale", {1, 1, 2}}}};
  json["scenes"][0]["nodes"] = {0, 1};
  const TriangleMesh mesh = read(glb(json, three_points()));
  // Quarter turn about y after z doubled: (x, y, z) to (2 z, y, -x), then the parent's shift.
  const std::vector<Point> expected{
      {2000, -3000, 2000},  {5000, -3000, 2000},  {2000, -3000, 5000},
      {7000, 1000, 2000},   {7000, 4000, 2000},   {7000, 1000, 5000},
      {-2000, -3000, 2000}, {-8000, -3000, 2000}, {-2000, -3000, 5000}};
  ASSERT_EQ(mesh.vertices.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mesh.vertices[i][axis], expected[i][axis], 1e-3) << i;
    }
  }
  // The mirrored one is turned over.
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}, {6, 8, 7}}));
}

TEST(GlbReader, ReadsEveryIndexTypeAndStridedPositions) {
  const std::vector<std::pair<int, std::string>> index_types{
      {5121, std::string("\2\0\1", 3)},
      {5123, std::string("\2\0\0\0\1\0", 6)},
      {5125, std::string("\2\0\0\0\0\0\0\0\1\0\0\0", 12)}};
  for (const auto& [type, indices] : index_types) {
    Json json = triangle_json();
    std::string data;
    for (std::size_t i = 0; i < 3; ++i) {
      data += three_points().substr(12 * i, 12) + "1234";
    }
    json["bufferViews"][0]["byteLength"] = 44;
    json["bufferViews"][0]["byteStride"] = 16;
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", indices.size()}});
    json["buffers"][0]["byteLength"] = 48 + indices.size();
    json["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", type}, {"count", 3}, {"type", "SCALAR"}});
    json["meshes"][0]["primitives"][0]["indices"] = 1;
    expect_same_mesh(
        read(glb(json, data + indices)),
        {{{1000, -3000, 2000}, {4000, -3000, 2000}, {1000, -3000, 5000}}, {{2, 0, 1}}});
  }
}

TEST(GlbReader, SaysWhatIsWrong) {
  const auto changed = [](const std::string& place, const Json& value) {
    Json json = triangle_json();
    json[Json::json_pointer(place)] = value;
    return complaint(glb(json, three_points()));
  };
  EXPECT_EQ(changed("/nodes/0/name", "part"), "");
  const std::vector<std::tuple<std::string, Json, std::string>> cases{
      {"/accessors/0/count", 4, "reaches past its data"},
      {"/accessors/0/count", 0, "reaches past its data"},
      {"/accessors/0/count", 18446744073709551615U, "reaches past its data"},
      {"/accessors/0/byteOffset", 4, "reaches past its data"},
      {"/accessors/0/byteOffset", 18446744073709551612U, "reaches past its data"},
      {"/accessors/0/bufferView", 7, ""},
      {"/accessors/0/bufferView", -3, ""},
      {"/accessors/0/type", "VEC2", "three float32"},
      {"/accessors/0/componentType", 5123, "three float32"},
      {"/accessors/0/sparse",
       Json::parse(R"({"count": 1, "indices": {"bufferView": 0, "componentType": 5125},
                       "values": {"bufferView": 0}})"),
       "sparse"},
      {"/bufferViews/0/byteLength", 40, "reaches past its data"},
      {"/bufferViews/0/byteOffset", 4, "reaches past its data"},
      {"/bufferViews/0/byteStride", 8, ""},
      {"/bufferViews/0/buffer", 1, ""},
      {"/buffers/0/byteLength", 4000000000U, ""},
      {"/buffers/0/uri", "other.bin", ""},
      {"/meshes/0/primitives/0/attributes/POSITION", 1, "names accessor 1"},
      {"/meshes/0/primitives/0/indices", 9, ""},
      {"/meshes/0/primitives/0/indices", 0, "vertex indices"},
      {"/meshes/0/primitives/0/mode", 5, "strips"},
      {"/nodes/0/mesh", 1, "names mesh 1"},
      {"/nodes/0/children", Json({0}), "two parents"},
      {"/nodes/0/children", Json({5}), "names node 5"},
      {"/scene", 2, "names scene 2"},
      {"/scenes", Json::array(), "no scene"},
      {"/scenes/0/nodes", Json({0, 0}), "two parents"},
      {"/extensionsRequired", Json({"KHR_draco_mesh_compression"}), "KHR_draco_mesh_compression"},
      {"/asset/version", "1.0", ""}};
  for (const auto& [place, value, reason] : cases) {
    const std::string said = changed(place, value);
    // tinygltf itself finds some of them, in words of its own; version is not looked at.
    EXPECT_TRUE(place == "/asset/version" || !said.empty()) << place << " " << value;
    EXPECT_NE(said.find(reason), std::string::npos) << place << " " << value << ": " << said;
  }
}

TEST(GlbReader, RefusesDeepNesting) {
  Json json = triangle_json();
  std::string bytes = glb(json, three_points());
  json["extras"] = "DEEP";
  std::string text = json.dump();
  text.replace(text.find("\"DEEP\""), 6, std::string(200000, '[') + std::string(200000, ']'));
  text.resize((text.size() + 3) / 4 * 4, ' ');
  bytes = "glTF" + uint32_bytes(2) + uint32_bytes(28 + text.size() + 36) +
          uint32_bytes(text.size()) + "JSON" + text + uint32_bytes(36) + std::string("BIN\0", 4) +
          three_points();
  EXPECT_NE(complaint(bytes).find("too deeply"), std::string::npos);
}

TEST(GlbReader, CutAnywhereOrTooLong) {
  const std::string bytes = encode_glb(example_scene(true));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(complaint(bytes.substr(0, size)), "") << size;
  }
  EXPECT_NE(complaint(bytes + "1234"), "");
}

/// Bytes of the JSON changed at random, or whole values exchanged for others.
TEST(GlbReader, RandomDamageNeverCrashes) {
  constexpr unsigned seed = 71;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::string original = encode_glb(example_scene(true));
  const Parts parts(original);
  const std::vector<Json> values{-1,
                                 0,
                                 5,
                                 1e30,
                                 "text",
                                 nullptr,
                                 true,
                                 Json::array(),
                                 Json::object(),
                                 {1, 2},
                                 4294967296U,
                                 -9000000000000};
  const Json flat = parts.json.flatten();
  for (int trial = 0; trial < 4000; ++trial) {
    std::string bytes = original;
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      bytes[random() % (bytes.size() - parts.data.size())] = static_cast<char>(random());
    }
    complaint(bytes);
    Json json = parts.json;
    Json::json_pointer place(std::next(flat.begin(), random() % flat.size()).key());
    for (std::size_t up = random() % 3; up > 0 && !place.parent_pointer().empty(); --up) {
      place = place.parent_pointer();
    }
    json[place] = values[random() % values.size()];
    complaint(glb(json, parts.data));
  }
}

}  // namespace
}  // namespace latticast
