// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of GLB, and the extensions that other programs use for them.
#include <cmath>

#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/glb_file.h"
#include "tests/unit/export/mesh/glb_bytes.h"

namespace latticast {
namespace {

std::vector<MeshObject> objects_of(const Json& json, const std::string& data = three_points(),
                                   const MeshLimits& limits = {}) {
  return decode_glb("a.glb", glb(json, data), limits);
}

std::string complaint(const Json& json, const std::string& data = three_points(),
                      const MeshLimits& limits = {}) {
  try {
    objects_of(json, data, limits);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

bool says(const std::string& complaint, const std::string& words) {
  return complaint.find(words) != std::string::npos;
}

/// Numbers behind those that are there, and an accessor that names them.
template <typename Number>
void add_accessor(Json& json, std::string& data, const std::vector<Number>& numbers,
                  const std::string& type, int component, bool normalized = false) {
  data.resize((data.size() + 3) / 4 * 4, '\0');
  const std::size_t size = numbers.size() * sizeof(Number);
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size()},
                               {"componentType", component},
                               {"normalized", normalized},
                               {"count", numbers.size() / (type == "VEC4" ? 4 : 3)},
                               {"type", type}});
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", size}});
  data.append(reinterpret_cast<const char*>(numbers.data()), size);
  json["buffers"][0]["byteLength"] = data.size();
}

TEST(GlbObjects, AreTheNodesWithTheirNames) {
  Json json = triangle_json();
  json["nodes"] = {{{"mesh", 0}, {"name", "left"}, {"children", {1}}}, {{"mesh", 0}}};
  json["meshes"][0]["name"] = "shape";
  const auto objects = objects_of(json);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "left");
  EXPECT_EQ(objects[1].name, "shape");
}

TEST(GlbObjects, PrimitivesOfOneMeshAreOneObject) {
  Json json = triangle_json();
  json["meshes"][0]["primitives"].push_back(json["meshes"][0]["primitives"][0]);
  const auto objects = objects_of(json);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].mesh.triangles.size(), 2U);
}

TEST(GlbObjects, PrimitivesThatAreClosedAreObjectsOfTheirOwn) {
  Json json = triangle_json();
  std::string data = three_points();
  add_accessor<float>(json, data, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", 5126);
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", 12}});
  data += std::string("\0\2\1\0\1\3\0\3\2\1\2\3", 12);
  json["buffers"][0]["byteLength"] = data.size();
  json["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5121}, {"count", 12}, {"type", "SCALAR"}});
  const Json closed = {{"attributes", {{"POSITION", 1}}}, {"indices", 2}};
  json["meshes"][0]["primitives"] = {closed, closed};
  EXPECT_EQ(objects_of(json, data).size(), 2U);
  json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
  EXPECT_EQ(objects_of(json, data).size(), 1U);
}

TEST(GlbObjects, AreAsManyAsThereAreInstances) {
  Json json = triangle_json();
  std::string data = three_points();
  const auto half = static_cast<std::int16_t>(std::lround(32767 * std::sqrt(0.5)));
  add_accessor<float>(json, data, {0, 0, 0, 10, 0, 0}, "VEC3", 5126);
  add_accessor<std::int16_t>(json, data, {0, 0, 0, 32767, 0, half, 0, half}, "VEC4", 5122, true);
  add_accessor<float>(json, data, {1, 1, 1, 1, 1, -2}, "VEC3", 5126);
  json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", 1}, {"ROTATION", 2}, {"SCALE", 3}};
  json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const auto objects = objects_of(json, data);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].mesh.vertices[0], (Point{1000, -3000, 2000}));
  // z times -2, then a quarter turn about y, (x, y, z) to (z, y, -x), then the shift: (4, 2, -1).
  const Point moved{4000, 1000, 2000};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(objects[1].mesh.vertices[0][axis], moved[axis], 0.5) << axis;
  }
  EXPECT_EQ(objects[1].mesh.triangles[0], (Triangle{0, 2, 1}));  // mirrored
  json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  EXPECT_EQ(objects_of(json, data).size(), 2U);
  json["accessors"][2]["count"] = 1;
  EXPECT_TRUE(says(complaint(json, data), "contradict"));
}

TEST(GlbObjects, InvisibleNodesAreLeftOutWithAllBelowThem) {
  Json json = triangle_json();
  json["nodes"] = {{{"mesh", 0}, {"children", {1, 2}}},
                   {{"mesh", 0}, {"children", {3}}},
                   {{"mesh", 0}},
                   {{"mesh", 0}}};
  json["extensionsUsed"] = {"KHR_node_visibility"};
  EXPECT_EQ(objects_of(json).size(), 4U);
  json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
  EXPECT_EQ(objects_of(json).size(), 2U);
  json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = true;
  EXPECT_EQ(objects_of(json).size(), 4U);
}

TEST(GlbReader, NamesExtensionsThatChangeMeshes) {
  const auto said = [](const std::string& list, const std::string& extension) {
    Json json = triangle_json();
    json["extensionsUsed"] = {extension};
    json[list] = {extension};
    return complaint(json);
  };
  for (const std::string extension :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
        "KHR_mesh_quantization", "ACME_new"}) {
    EXPECT_TRUE(says(said("extensionsRequired", extension), extension)) << extension;
  }
  for (const std::string extension : {"EXT_meshopt_compression", "ACME_instancing"}) {
    EXPECT_TRUE(says(said("extensionsUsed", extension), extension)) << extension;
  }
  for (const std::string extension :
       {"KHR_materials_unlit", "KHR_texture_basisu", "EXT_texture_webp", "KHR_lights_punctual"}) {
    EXPECT_EQ(said("extensionsRequired", extension), "");
  }
  for (const std::string extension : {"ACME_new", "KHR_draco_mesh_compression"}) {
    EXPECT_EQ(said("extensionsUsed", extension), "");  // the plain data stand beside it
  }
}

/// A file that says "used" only, with data that nothing but the extension can read.
TEST(GlbReader, NamesCompressionWhereThePlainDataAreMissing) {
  Json json = triangle_json();
  json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  json["accessors"][0].erase("bufferView");
  EXPECT_TRUE(says(complaint(json), "KHR_draco_mesh_compression")) << complaint(json);
}

TEST(GlbReader, BoundsWhatAFileMayAskFor) {
  const auto at_most = [](std::size_t uses) {
    MeshLimits limits;
    limits.uses = uses;
    return limits;
  };
  Json json = triangle_json();
  json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}};
  json["scenes"][0]["nodes"] = {0, 1, 2};
  EXPECT_EQ(complaint(json, three_points(), at_most(3)), "");
  EXPECT_TRUE(says(complaint(json, three_points(), at_most(2)), "too many times"));
  std::string data = three_points();
  add_accessor<float>(json, data, std::vector<float>(9), "VEC3", 5126);
  json["nodes"] = {{{"mesh", 0}}};
  json["scenes"][0]["nodes"] = {0};
  json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 1}};
  EXPECT_EQ(complaint(json, data, at_most(3)), "");
  EXPECT_TRUE(says(complaint(json, data, at_most(2)), "too many times"));
}

}  // namespace
}  // namespace latticast
