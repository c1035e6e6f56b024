// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "design/file_error.h"
#include "export/mesh/three_mf_file.h"
#include "export/mesh/three_mf_model.h"
#include "export/mesh/xml_reader.h"
#include "export/mesh/zip_archive.h"

namespace latticast {
namespace {

constexpr std::string_view model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// The models that a part of relationships names, in their order. Names are relative to `folder`.
std::vector<std::string> models_named(const std::filesystem::path& file, const ZipReader& package,
                                      const std::string& relationships, const std::string& folder) {
  std::vector<std::string> names;
  XmlReader xml(file,
                {.start =
                     [&](std::string_view element, const XmlAttributes& attributes) {
                       if ((element == "Relationship" || element.ends_with("|Relationship")) &&
                           attributes.find("Type") == model_relationship) {
                         const std::string name(attributes.find("Target").value_or(""));
                         names.push_back(name.starts_with('/') ? name.substr(1) : folder + name);
                       }
                     },
                 .end = [](std::string_view) {}});
  package.read(relationships, [&](std::string_view piece) { xml.read(piece); });
  xml.finish();
  return names;
}

/// The model parts of the package, the root last: it uses objects of the others.
std::vector<std::string> model_parts(const std::filesystem::path& file, const ZipReader& package) {
  const std::vector<std::string> roots = models_named(file, package, "_rels/.rels", "");
  if (roots.empty() || roots.back().empty()) {
    throw FileError(file, "names no 3MF model inside");
  }
  const std::string& root = roots.back();
  const std::size_t slash = root.rfind('/') + 1;  // 0 where there is none
  const std::string folder = root.substr(0, slash);
  const std::string relationships = folder + "_rels/" + root.substr(slash) + ".rels";
  std::vector<std::string> parts;
  if (package.has(relationships)) parts = models_named(file, package, relationships, folder);
  for (std::string& part : parts) part = part_name(part);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  std::erase(parts, part_name(root));
  parts.push_back(root);
  return parts;
}

ThreeMfModel read_model(const std::filesystem::path& file, const ZipReader& package,
                        const MeshLimits& limits) {
  const SlicerSettings settings = read_slicer_settings(file, package);
  ThreeMfModel model;
  for (const std::string& part : model_parts(file, package)) {
    ThreeMfModelReader reader(file, part, settings, limits, model);
    package.read(part, [&](std::string_view piece) { reader.read(piece); });
    reader.finish();
  }
  return model;
}

TriangleMesh placed_body(const Placement& placement, const TriangleMesh& body) {
  TriangleMesh mesh;
  mesh.vertices.reserve(body.vertices.size());
  for (const Point& vertex : body.vertices) {
    mesh.vertices.push_back(placed(placement, vertex));
  }
  mesh.triangles = body.triangles;
  if (mirrors(placement)) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

// As deep as objects are nested, which is bounded.
void place(const ThreeMfModel& model, const ThreeMfUse& used, const std::string& outer_name,
           std::vector<MeshObject>& placed_objects) {
  const ThreeMfObject& object = model.objects.at(used.object);
  const std::string& name = object.name.empty() ? outer_name : object.name;
  for (const TriangleMesh& body : object.bodies) {
    placed_objects.push_back({name, placed_body(used.placement, body)});
  }
  for (const ThreeMfUse& component : object.components) {
    place(model, {component.object, placed(used.placement, component.placement)}, name,
          placed_objects);
  }
}

// A mesh that is used once takes what the file takes, however large.
void require_bounded(const std::filesystem::path& file, const ThreeMfModel& model,
                     const MeshLimits& limits) {
  std::size_t held = 0;
  for (const auto& [key, object] : model.objects) {
    for (const TriangleMesh& body : object.bodies) held += body.triangles.size();
  }
  const std::size_t most = std::max(held, limits.triangles);
  std::size_t uses = 0;
  std::size_t triangles = 0;
  for (const ThreeMfUse& item : model.items) {
    const ThreeMfObject& object = model.objects.at(item.object);
    if (object.uses > limits.uses - uses || object.triangles > most - triangles) {
      throw FileError(file, "uses its objects too many times: more than " +
                                std::to_string(limits.uses) + " meshes, or " +
                                std::to_string(most) + " triangles");
    }
    uses += object.uses;
    triangles += object.triangles;
  }
}

}  // namespace

std::vector<MeshObject> decode_three_mf(const std::filesystem::path& file, std::string_view bytes,
                                        const MeshLimits& limits) {
  const ZipReader package(file, bytes);
  const ThreeMfModel model = read_model(file, package, limits);
  require_bounded(file, model, limits);
  std::vector<MeshObject> objects;
  for (const ThreeMfUse& item : model.items) {
    place(model, {item.object, placed(model.unit, item.placement)}, "", objects);
  }
  if (objects.empty() && model.left_out > 0) {
    throw FileError(file,
                    "has nothing that is printed: only modifiers, supports and parts that are "
                    "marked as not printable");
  }
  return objects;
}

}  // namespace latticast
