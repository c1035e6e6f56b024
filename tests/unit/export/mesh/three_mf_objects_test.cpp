// SPDX-License-Identifier: GPL-3.0-or-later
// What slicers and other programs put into a 3MF beside plain meshes.
#include <functional>

#include <gtest/gtest.h>

#include "design/file_error.h"
#include "export/mesh/three_mf_file.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/mesh/three_mf_packages.h"

namespace latticast {
namespace {

std::vector<MeshObject> objects_of(const std::string& bytes, const MeshLimits& limits = {}) {
  return decode_three_mf("a.3mf", bytes, limits);
}

std::string complaint(const std::string& bytes, const MeshLimits& limits = {}) {
  try {
    objects_of(bytes, limits);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

bool says(const std::string& complaint, const std::string& words) {
  return complaint.find(words) != std::string::npos;
}

/// Boxes of 10 x 20 x 30 mm in one mesh.
std::string box_mesh(const std::vector<Point>& lows) {
  constexpr std::array<std::array<std::size_t, 3>, 12> corners{{{0, 2, 3},
                                                                {0, 3, 1},
                                                                {4, 5, 7},
                                                                {4, 7, 6},
                                                                {0, 1, 5},
                                                                {0, 5, 4},
                                                                {1, 3, 7},
                                                                {1, 7, 5},
                                                                {3, 2, 6},
                                                                {3, 6, 7},
                                                                {2, 0, 4},
                                                                {2, 4, 6}}};
  std::string vertices;
  std::string triangles;
  for (std::size_t box = 0; box < lows.size(); ++box) {
    const Point& low = lows[box];
    for (std::size_t i = 0; i < 8; ++i) {
      vertices += "<c:vertex x=\"" + std::to_string(low[0] + ((i & 1U) != 0 ? 10 : 0)) + "\" y=\"" +
                  std::to_string(low[1] + ((i & 2U) != 0 ? 20 : 0)) + "\" z=\"" +
                  std::to_string(low[2] + ((i & 4U) != 0 ? 30 : 0)) + "\"/>";
    }
    for (const auto& t : corners) {
      triangles += "<c:triangle v1=\"" + std::to_string(8 * box + t[0]) + "\" v2=\"" +
                   std::to_string(8 * box + t[1]) + "\" v3=\"" + std::to_string(8 * box + t[2]) +
                   "\"/>";
    }
  }
  return "<c:mesh><c:vertices>" + vertices + "</c:vertices><c:triangles>" + triangles +
         "</c:triangles></c:mesh>";
}

std::string box_object(int id, const std::vector<Point>& lows, const std::string& attributes = "",
                       const std::string& inside = "") {
  return "<c:object id=\"" + std::to_string(id) + "\" " + attributes + ">" + inside +
         box_mesh(lows) + "</c:object>";
}

std::string assembly(int id, const std::vector<int>& components) {
  std::string uses;
  for (const int component : components) {
    uses += "<c:component objectid=\"" + std::to_string(component) + "\"/>";
  }
  return "<c:object id=\"" + std::to_string(id) + "\"><c:components>" + uses +
         "</c:components></c:object>";
}

std::string relationships_to(const std::string& target) {
  return "<Relationships><Relationship Target=\"" + target +
         "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
         "</Relationships>";
}

std::string package_with(const std::string& model, const std::string& name,
                         const std::string& settings) {
  return zip(std::array<ZipEntry, 3>{{{"_rels/.rels", relationships_to("/3D/3dmodel.model")},
                                      {"3D/3dmodel.model", model},
                                      {name, settings}}});
}

const std::string item_1 = "<c:item objectid=\"1\"/>";
const std::string item_2 = "<c:item objectid=\"2\"/>";
const std::string item_3 = "<c:item objectid=\"3\"/>";

TEST(ThreeMfObjects, ComeOneByOneWithTheirNames) {
  const std::string resources = box_object(1, {{0, 0, 0}}, "name=\"left\"") +
                                box_object(2, {{10, 0, 0}}) + assembly(3, {1, 2});
  const auto objects = objects_of(package(model_of(resources, item_3 + item_1)));
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[0].name, "left");
  EXPECT_EQ(objects[1].name, "");
  for (const MeshObject& object : objects) {
    EXPECT_EQ(object.mesh.triangles.size(), 12U);
  }
  EXPECT_EQ(objects[1].mesh.vertices[0], (Point{10, 0, 0}));
}

TEST(ThreeMfObjects, VolumesOfPrusaSlicerThatAreNoPartsAreLeftOut) {
  const std::string model = model_of(box_object(1, {{0, 0, 0}, {50, 0, 0}, {100, 0, 0}}), item_1);
  const auto settings = [](const std::string& key, const std::string& second) {
    const auto volume = [&](int first, const std::string& value) {
      return "<volume firstid=\"" + std::to_string(first) + "\" lastid=\"" +
             std::to_string(first + 11) +
             "\"><metadata type=\"volume\" key=\"name\" value=\"a\"/>"
             "<metadata type=\"volume\" key=\"" +
             key + "\" value=\"" + value + "\"/></volume>";
    };
    const std::string part = key == "modifier" ? "0" : "ModelPart";
    return "<config><object id=\"1\">" + volume(0, part) + volume(12, second) + volume(24, part) +
           "</object></config>";
  };
  const std::string name = "Metadata/Slic3r_PE_model.config";
  for (const std::string type :
       {"ParameterModifier", "NegativeVolume", "SupportBlocker", "SupportEnforcer"}) {
    const auto objects = objects_of(package_with(model, name, settings("volume_type", type)));
    ASSERT_EQ(objects.size(), 2U) << type;
    EXPECT_EQ(objects[1].mesh.vertices.size(), 8U);
    EXPECT_EQ(objects[1].mesh.vertices[0], (Point{100, 0, 0}));
  }
  EXPECT_EQ(objects_of(package_with(model, name, settings("volume_type", "ModelPart"))).size(), 3U);
  EXPECT_EQ(objects_of(package_with(model, name, settings("modifier", "1"))).size(), 2U);
}

TEST(ThreeMfObjects, VolumesOfSlic3rThatAreModifiersAreLeftOut) {
  const std::string volumes =
      "<r:volumes xmlns:r=\"http://schemas.slic3r.org/3mf/2017/06\"><r:volume ts=\"0\" te=\"11\" "
      "modifier=\"0\"/><r:volume ts=\"12\" te=\"23\" modifier=\"1\"/></r:volumes>";
  const auto objects =
      objects_of(package(model_of(box_object(1, {{0, 0, 0}, {50, 0, 0}}, "", volumes), item_1)));
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].mesh.triangles.size(), 12U);
}

TEST(ThreeMfObjects, PartsOfBambuStudioThatAreNotNormalAreLeftOut) {
  const std::string model =
      model_of(box_object(1, {{0, 0, 0}}) + box_object(2, {{50, 0, 0}}) + assembly(3, {1, 2}),
               "<c:item objectid=\"3\" printable=\"1\"/>");
  for (const std::string type :
       {"negative_part", "modifier_part", "support_blocker", "support_enforcer", "normal_part"}) {
    const std::string settings =
        "<config><object id=\"3\"><metadata key=\"name\" value=\"a\"/>"
        "<part id=\"1\" subtype=\"normal_part\"/><part id=\"2\" subtype=\"" +
        type + "\"/></object></config>";
    EXPECT_EQ(objects_of(package_with(model, "Metadata/model_settings.config", settings)).size(),
              type == "normal_part" ? 2U : 1U)
        << type;
  }
}

/// Bambu Studio and Orca Slicer keep each mesh in a model of its own.
TEST(ThreeMfObjects, OfOtherModelsInThePackageAreRead) {
  const auto uses = [](const std::string& path) {
    return model_of(
        "<c:object id=\"8\"><c:components><c:component p:path=\"" + path +
            "\" objectid=\"1\"/><c:component p:path=\"/3D/Objects/a%20b.model\" objectid=\"2\" "
            "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></c:components></c:object>",
        "<c:item objectid=\"8\"/>", "requiredextensions=\"p\"");
  };
  const std::string parts = model_of(
      box_object(1, {{0, 0, 0}}) + box_object(2, {{50, 0, 0}}, "type=\"model\""), item_1 + item_2);
  const std::string settings =
      "<config><object id=\"8\"><part id=\"1\" subtype=\"normal_part\"/><part id=\"2\" "
      "subtype=\"modifier_part\"/></object></config>";
  const auto bytes = [&](const std::string& path, const std::string& target,
                         const std::string& config) {
    return zip(std::array<ZipEntry, 5>{{{"_rels/.rels", relationships_to("/3D/3dmodel.model")},
                                        {"3D/3dmodel.model", uses(path)},
                                        {"3D/_rels/3dmodel.model.rels", relationships_to(target)},
                                        {"3D/Objects/a b.model", parts},
                                        {"Metadata/" + config, settings}}});
  };
  const std::string path = "/3D/Objects/a b.model";
  for (const std::string& target : {path, std::string("Objects/a%20b.model")}) {
    const auto objects = objects_of(bytes(path, target, "other.config"));
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_EQ(objects[1].mesh.vertices[0], (Point{55, 0, 0}));
  }
  EXPECT_EQ(objects_of(bytes(path, path, "model_settings.config")).size(), 1U);
  EXPECT_TRUE(says(complaint(bytes("/3D/c.model", path, "other.config")),
                   "no object 1 in \"/3D/c.model\""));
  EXPECT_TRUE(says(complaint(bytes(path, "/3D/missing.model", "other.config")), "missing.model"));
}

TEST(ThreeMfObjects, MeshesOfCuraThatChangeOthersAreLeftOut) {
  for (const std::string key : {"infill_mesh", "cutting_mesh", "anti_overhang_mesh", "support_mesh",
                                "drop_to_buildplate"}) {
    const std::string setting = "<c:metadatagroup><c:metadata name=\"cura:" + key +
                                "\">True</c:metadata></c:metadatagroup>";
    const std::string model = model_of(
        box_object(1, {{0, 0, 0}}) + box_object(2, {{50, 0, 0}}, "", setting), item_1 + item_2);
    EXPECT_EQ(objects_of(package(model)).size(), key == "drop_to_buildplate" ? 2U : 1U) << key;
  }
}

TEST(ThreeMfObjects, SupportsAndWhatIsNotPrintableAreLeftOut) {
  for (const std::string type : {"support", "solidsupport", "other", "model", "surface"}) {
    std::string resources = box_object(1, {{0, 0, 0}});
    resources += box_object(2, {{50, 0, 0}}, "type=\"" + type + "\"");
    resources += assembly(3, {1, 2});
    const std::size_t printed = type == "model" || type == "surface" ? 2 : 1;
    EXPECT_EQ(objects_of(package(model_of(resources, item_3))).size(), printed) << type;
    EXPECT_EQ(objects_of(package(model_of(resources, item_1 + item_2))).size(), printed) << type;
  }
  const std::string box = box_object(1, {{0, 0, 0}});
  const std::string hidden = "<c:item objectid=\"1\" printable=\"0\"/>";
  EXPECT_EQ(objects_of(package(model_of(box, hidden + item_1))).size(), 1U);
  EXPECT_TRUE(says(complaint(package(model_of(box, hidden))), "nothing that is printed"));
}

TEST(ThreeMfReader, RefusesRequiredExtensionsThatMayChangeTheGeometry) {
  const auto said = [](const std::string& name_space, const std::string& required) {
    return complaint(package(
        model_of(triangle_object, item_1,
                 "xmlns:x=\"" + name_space + "\" requiredextensions=\"" + required + "\"")));
  };
  const std::string three_mf = "http://schemas.3mf.io/3dmanufacturing/";
  const std::string microsoft = "http://schemas.microsoft.com/3dmanufacturing/";
  for (const std::string& name :
       {three_mf + "booleanoperations/2023/07", three_mf + "volumetric/2022/01",
        microsoft + "beamlattice/2017/02", std::string("http://example.org/new")}) {
    EXPECT_TRUE(says(said(name, "s x"), "\"x\" (" + name + ")")) << said(name, "s x");
  }
  EXPECT_TRUE(says(said("http://example.org/new", "y"), "extension \"y\""));
  for (const std::string& name : {microsoft + "material/2015/02", microsoft + "slice/2015/07",
                                  microsoft + "production/2015/06"}) {
    EXPECT_EQ(said(name, "x"), "");
  }
  EXPECT_EQ(said("http://example.org/new", ""), "");  // known, but not required
}

TEST(ThreeMfReader, SlicesMayStandBesideAFullMeshOnly) {
  const auto said = [](const std::string& resolution) {
    return complaint(package(model_of(
        box_object(1, {{0, 0, 0}}, "s:slicestackid=\"9\" s:meshresolution=\"" + resolution + "\""),
        item_1, "requiredextensions=\"s\"")));
  };
  EXPECT_EQ(said("fullres"), "");
  EXPECT_TRUE(says(said("lowres"), "given in slices"));
}

TEST(ThreeMfReader, TakesSignsInNumbers) {
  const auto objects = objects_of(package(
      model_of(triangle_object,
               "<c:item objectid=\"+1\" transform=\"+1 0 0 0 +1.0 0 0 0 +1e0 +1.0E+01 -2 +0\"/>")));
  expect_same_mesh(objects.at(0).mesh, {{{11, 0, 3}, {14, 0, 3}, {11, 3, 3}}, {{0, 1, 2}}});
  const std::string two_signs = "<c:item objectid=\"1\" transform=\"+-1 0 0 0 1 0 0 0 1 0 0 0\"/>";
  EXPECT_TRUE(says(complaint(package(model_of(triangle_object, two_signs))), "twelve numbers"));
}

TEST(ThreeMfReader, FindsTheModelWhateverCodesItsNameHas) {
  const std::string model = model_of(triangle_object, item_1);
  const auto read_as = [&](const std::string& target, const std::string& entry) {
    return complaint(
        zip(std::array<ZipEntry, 2>{{{"_rels/.rels", relationships_to(target)}, {entry, model}}}));
  };
  EXPECT_EQ(read_as("/3D/my%20part%5B1%5D.model", "3D/my part[1].model"), "");
  EXPECT_EQ(read_as("/3D/my part.model", "3D/my%20part.model"), "");
  EXPECT_EQ(read_as("/3D/teil-%C3%BC.model", "3D/teil-ü.model"), "");
  EXPECT_EQ(read_as("3D/A.model", "3d/a.MODEL"), "");
  EXPECT_EQ(read_as("./3D/a.model", "3D/a.model"), "");
  EXPECT_EQ(read_as("/3D/100%.model", "3D/100%.model"), "");
  EXPECT_NE(read_as("/3D/a%20b.model", "3D/ab.model"), "");
}

TEST(ThreeMfReader, TakesTheNamespaceOfTheDraftAndNone) {
  const std::string name_of_2015 = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
  const auto with = [&](const std::string& name) {
    std::string text = model_of(triangle_object, item_1);
    return text.replace(text.find(name_of_2015), name_of_2015.size(), name);
  };
  EXPECT_EQ(complaint(package(with("http://schemas.microsoft.com/3dmanufacturing/2013/01"))), "");
  EXPECT_TRUE(says(complaint(package(with("http://example.org"))), "\"http://example.org\""));
  const std::string plain =
      "<model unit=\"inch\"><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
      "z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></vertices>"
      "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object></resources>"
      "<build><item objectid=\"1\"/></build></model>";
  EXPECT_EQ(objects_of(package(plain)).at(0).mesh.vertices[1], (Point{25.4F, 0, 0}));
}

TEST(ThreeMfReader, AnObjectWithoutAnythingThatIsReadIsRefused) {
  EXPECT_TRUE(says(complaint(package(model_of("<c:object id=\"1\"/>", item_1))),
                   "neither a mesh nor components"));
}

TEST(ThreeMfReader, BoundsWhatAFileMayAskFor) {
  const auto said = [](const std::string& resources, const std::string& build,
                       const std::function<void(MeshLimits&)>& limit) {
    MeshLimits limits;
    limit(limits);
    return complaint(package(model_of(resources, build)), limits);
  };
  const auto depth = [](std::size_t most) { return [=](MeshLimits& l) { l.depth = most; }; };
  const auto components = [](std::size_t n) { return [=](MeshLimits& l) { l.components = n; }; };
  const auto items = [](std::size_t most) { return [=](MeshLimits& l) { l.items = most; }; };
  const auto uses = [](std::size_t most) { return [=](MeshLimits& l) { l.uses = most; }; };
  const auto triangles = [](std::size_t n) { return [=](MeshLimits& l) { l.triangles = n; }; };

  std::string chain = triangle_object;
  for (int i = 2; i <= 5; ++i) {
    chain += assembly(i, {i - 1});
  }
  const std::string last = "<c:item objectid=\"5\"/>";
  EXPECT_EQ(said(chain, last, depth(5)), "");
  EXPECT_TRUE(says(said(chain, last, depth(4)), "more than 4 deep"));
  EXPECT_EQ(said(chain, last, components(4)), "");
  EXPECT_TRUE(says(said(chain, last, components(3)), "more than 3 components"));
  EXPECT_EQ(said(triangle_object, item_1 + item_1, items(2)), "");
  EXPECT_TRUE(says(said(triangle_object, item_1 + item_1, items(1)), "more than 1 items"));

  const std::string four = triangle_object + assembly(2, {1, 1}) + assembly(3, {2, 2});
  EXPECT_EQ(said(four, item_3, uses(4)), "");
  EXPECT_TRUE(says(said(four, item_3, uses(3)), "more than 3 meshes"));
  EXPECT_EQ(said(four, item_3, triangles(4)), "");
  EXPECT_TRUE(says(said(four, item_3, triangles(3)), "3 triangles"));
  // What the file itself holds is never too much.
  EXPECT_EQ(said(box_object(1, {{0, 0, 0}}), item_1, triangles(1)), "");
}

/// Read in pieces of one size, it would cost their number squared.
TEST(ThreeMfReader, TakesAVeryLongAttribute) {
  const std::string name(8000000, 'n');
  const auto objects =
      objects_of(package(model_of(box_object(1, {{0, 0, 0}}, "name=\"" + name + "\""), item_1)));
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].name, name);
  const std::string id(100000, '7');
  EXPECT_LT(complaint(package(model_of("<c:object id=\"" + id + "\"/>", item_1))).size(), 300U);
}

}  // namespace
}  // namespace latticast
