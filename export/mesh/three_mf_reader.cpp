// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/placement.h"
#include "export/mesh/three_mf_file.h"
#include "export/mesh/xml_reader.h"
#include "export/mesh/zip_archive.h"

namespace latticast {
namespace {

constexpr std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
constexpr std::string_view path_elsewhere =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr std::string_view model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// An object where something uses it.
struct Use {
  std::uint32_t object = 0;
  Placement placement = in_place;
};

struct Object {
  TriangleMesh mesh;
  std::vector<Use> components;
};

/// The model's elements as they come by.
class ModelReader {
 public:
  explicit ModelReader(const std::filesystem::path& file)
      : file_(file),
        xml_(file, {[this](std::string_view name, const XmlAttributes& attributes) {
                      if (name.starts_with(core)) {
                        start(name.substr(core.size()), attributes);
                      }
                    },
                    [this](std::string_view name) {
                      if (name.starts_with(core) && name.substr(core.size()) == "object") {
                        end_object();
                      }
                    }}) {}

  void read(std::string_view piece) { xml_.read(piece); }

  /// All items of the build, placed.
  TriangleMesh finish() {
    xml_.finish();
    TriangleMesh mesh;
    for (const Use& item : items_) {
      append({item.object, placed(unit_, item.placement)}, mesh);
    }
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_,
                    "line " + std::to_string(xml_.line_number()) + " of the model: " + reason);
  }

  void start(std::string_view name, const XmlAttributes& attributes) {
    if (name == "vertex") {
      read_vertex(attributes);
    } else if (name == "triangle") {
      read_triangle(attributes);
    } else if (name == "object") {
      open_ = Object{};
      id_ = index(attributes, "id");
    } else if (name == "component") {
      open_object().components.push_back(use(attributes));
    } else if (name == "item") {
      items_.push_back(use(attributes));
    } else if (name == "model") {
      read_unit(attributes);
    }
  }

  Object& open_object() {
    if (!open_) {
      fail("is outside of an object");
    }
    return *open_;
  }

  void end_object() {
    if (!objects_.emplace(id_, std::move(open_object())).second) {
      fail("a second object " + std::to_string(id_));
    }
    open_.reset();
  }

  std::string_view text(const XmlAttributes& attributes, std::string_view name) const {
    const auto value = attributes.find(name);
    if (!value) {
      fail("the attribute " + std::string(name) + " is missing");
    }
    return *value;
  }

  std::uint32_t index(const XmlAttributes& attributes, std::string_view name) const {
    const std::string_view word = text(attributes, name);
    std::uint32_t value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
      fail(std::string("\"").append(word).append("\" is no index"));
    }
    return value;
  }

  void read_vertex(const XmlAttributes& attributes) {
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    Point point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view word = text(attributes, axes[axis]);
      const std::optional<float> value = float32_of(word);
      if (!value) {
        fail(std::string("\"").append(word).append("\" is no number"));
      }
      point[axis] = *value;
    }
    open_object().mesh.vertices.push_back(point);
  }

  void read_triangle(const XmlAttributes& attributes) {
    const Triangle triangle{index(attributes, "v1"), index(attributes, "v2"),
                            index(attributes, "v3")};
    TriangleMesh& mesh = open_object().mesh;
    const std::uint32_t highest = *std::max_element(triangle.begin(), triangle.end());
    if (highest >= mesh.vertices.size()) {
      fail("there is no vertex " + std::to_string(highest));
    }
    mesh.triangles.push_back(triangle);
  }

  void read_unit(const XmlAttributes& attributes) {
    constexpr std::array<std::pair<std::string_view, double>, 6> units{{{"micron", 0.001},
                                                                        {"millimeter", 1},
                                                                        {"centimeter", 10},
                                                                        {"inch", 25.4},
                                                                        {"foot", 304.8},
                                                                        {"meter", 1000}}};
    const std::string_view name = attributes.find("unit").value_or("millimeter");
    const auto* const unit = std::find_if(units.begin(), units.end(),
                                          [&](const auto& known) { return known.first == name; });
    if (unit == units.end()) {
      fail(std::string("\"").append(name).append("\" is no unit"));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      unit_[axis][axis] = unit->second;
    }
  }

  Use use(const XmlAttributes& attributes) const {
    if (attributes.find(path_elsewhere)) {
      fail("an object in another model, which is not read");
    }
    Use use{index(attributes, "objectid"), in_place};
    // Objects that are defined before they are used cannot contain themselves.
    if (objects_.count(use.object) == 0) {
      fail("there is no object " + std::to_string(use.object) + " before it");
    }
    if (const auto transform = attributes.find("transform")) {
      read_transform(*transform, use.placement);
    }
    return use;
  }

  void read_transform(std::string_view words, Placement& placement) const {
    LineReader line(words);
    line.next_line();
    for (Point& column : placement) {
      for (double& number : column) {
        const std::string_view word = line.next_word();
        const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
        if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
          fail("a transform needs twelve numbers");
        }
      }
    }
  }

  void append(const Use& used, TriangleMesh& mesh) {
    constexpr std::size_t most_uses = 1000000;
    const Object& object = objects_.at(used.object);
    if (++uses_ > most_uses ||
        object.mesh.vertices.size() >
            std::numeric_limits<std::uint32_t>::max() - mesh.vertices.size()) {
      throw FileError(file_, "uses its objects too many times");
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Point& vertex : object.mesh.vertices) {
      mesh.vertices.push_back(placed(used.placement, vertex));
    }
    const bool turned = mirrors(used.placement);
    for (const Triangle& t : object.mesh.triangles) {
      mesh.triangles.push_back(
          {first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
    }
    for (const Use& component : object.components) {
      append({component.object, placed(used.placement, component.placement)}, mesh);
    }
  }

  const std::filesystem::path& file_;
  XmlReader xml_;
  Placement unit_ = in_place;
  std::map<std::uint32_t, Object> objects_;
  std::optional<Object> open_;
  std::uint32_t id_ = 0;
  std::vector<Use> items_;
  std::size_t uses_ = 0;
};

/// The name of the model inside the package.
std::string model_name(const std::filesystem::path& file, const ZipReader& package) {
  std::string name;
  XmlReader xml(file, {[&](std::string_view element, const XmlAttributes& attributes) {
                         if (element.ends_with("|Relationship") &&
                             attributes.find("Type") == model_relationship) {
                           name = attributes.find("Target").value_or("");
                         }
                       },
                       [](std::string_view) {}});
  package.read("_rels/.rels", [&](std::string_view piece) { xml.read(piece); });
  xml.finish();
  if (name.empty()) {
    throw FileError(file, "names no 3MF model inside");
  }
  return name.substr(name.front() == '/' ? 1 : 0);
}

}  // namespace

TriangleMesh decode_three_mf(const std::filesystem::path& file, std::string_view bytes) {
  const ZipReader package(file, bytes);
  ModelReader model(file);
  package.read(model_name(file, package), [&](std::string_view piece) { model.read(piece); });
  return model.finish();
}

}  // namespace latticast
