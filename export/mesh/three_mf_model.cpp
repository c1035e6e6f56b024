// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/three_mf_model.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/xml_reader.h"
#include "export/mesh/zip_archive.h"

namespace latticast {
namespace {

// That of the core specification, that of its draft, and none, as some programs have it.
constexpr std::array<std::string_view, 3> core_namespaces{
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/2013/01", ""};
constexpr std::string_view path_elsewhere =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr std::string_view mesh_resolution =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|meshresolution";

// Extensions that leave the meshes as they are. Slices stand beside a mesh of full resolution
// unless meshresolution says otherwise, and parts elsewhere are refused where they are used.
constexpr std::array<std::string_view, 7> harmless{
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.slic3r.org/3mf/2017/06",
    "http://schemas.bambulab.com/package/2021"};

// Cura's meshes that change how others are printed.
constexpr std::array<std::string_view, 4> modifiers_of_cura{"infill_mesh", "cutting_mesh",
                                                            "anti_overhang_mesh", "support_mesh"};

std::size_t sum(std::size_t a, std::size_t b) {
  return a > std::numeric_limits<std::size_t>::max() - b ? std::numeric_limits<std::size_t>::max()
                                                         : a + b;
}

/// Takes runs of triangles out of a mesh, each with the vertices that it uses.
class Pieces {
 public:
  explicit Pieces(const TriangleMesh& mesh)
      : mesh_(mesh), number_(mesh.vertices.size(), none), left_(mesh.triangles.size(), true) {}

  bool has_all() const { return std::find(left_.begin(), left_.end(), false) == left_.end(); }

  /// What is left of the triangles from `first` until before `end`.
  TriangleMesh take(std::size_t first, std::size_t end) {
    TriangleMesh piece;
    std::vector<std::uint32_t> used;
    for (std::size_t i = first; i < std::min(end, left_.size()); ++i) {
      if (!left_[i]) continue;
      left_[i] = false;
      Triangle triangle = mesh_.triangles[i];
      for (std::uint32_t& vertex : triangle) vertex = number_in(piece, vertex, used);
      piece.triangles.push_back(triangle);
    }
    for (const std::uint32_t vertex : used) number_[vertex] = none;
    return piece;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t number_in(TriangleMesh& piece, std::uint32_t vertex,
                          std::vector<std::uint32_t>& used) {
    if (number_[vertex] == none) {
      number_[vertex] = static_cast<std::uint32_t>(piece.vertices.size());
      piece.vertices.push_back(mesh_.vertices[vertex]);
      used.push_back(vertex);
    }
    return number_[vertex];
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> number_;
  std::vector<bool> left_;
};

/// The printed volumes of a mesh, and what belongs to none.
std::vector<TriangleMesh> printed_pieces(TriangleMesh mesh,
                                         const std::vector<SlicerVolume>& volumes) {
  const std::size_t count = mesh.triangles.size();
  std::vector<TriangleMesh> pieces;
  Pieces parts(mesh);
  for (const SlicerVolume& volume : volumes) {
    if (volume.printed && volume.first == 0 && volume.last + 1 == count) continue;
    TriangleMesh piece = parts.take(volume.first, volume.last + 1);
    if (volume.printed) pieces.push_back(std::move(piece));
  }
  if (parts.has_all()) return {std::move(mesh)};
  pieces.push_back(parts.take(0, count));
  return pieces;
}

}  // namespace

/// The model's elements as they come by.
class ThreeMfModelReader::Events {
 public:
  Events(const std::filesystem::path& file, std::string_view part, const SlicerSettings& settings,
         const MeshLimits& limits, ThreeMfModel& model)
      : file_(file),
        part_(part_name(part)),
        settings_(settings),
        limits_(limits),
        model_(model),
        xml_(file, {.start = [this](std::string_view name,
                                    const XmlAttributes& attributes) { start(name, attributes); },
                    .end = [this](std::string_view name) { end(name); },
                    .text = [this](std::string_view text) { read_text(text); },
                    .prefix =
                        [this](std::string_view prefix, std::string_view name_space) {
                          prefixes_[std::string(prefix)] = name_space;
                        }}) {}

  void read(std::string_view piece) { xml_.read(piece); }

  void finish() { xml_.finish(); }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_,
                    "line " + std::to_string(xml_.line_number()) + " of the model: " + reason);
  }

  static std::pair<std::string_view, std::string_view> parted(std::string_view name) {
    const std::size_t bar = name.rfind('|');
    return bar == std::string_view::npos ? std::pair(std::string_view(), name)
                                         : std::pair(name.substr(0, bar), name.substr(bar + 1));
  }

  void start(std::string_view name, const XmlAttributes& attributes) {
    const auto [name_space, local] = parted(name);
    if (!core_) {
      start_model(name_space, local, attributes);
    } else if (name_space == *core_) {
      start_core(local, attributes);
    } else if (local == "volume" && open_) {
      read_volume(attributes);
    } else if (local == "setting" && open_) {
      flag_ = attributes.find("key").value_or("");
    }
  }

  void start_model(std::string_view name_space, std::string_view local,
                   const XmlAttributes& attributes) {
    if (local != "model") {
      fail("begins with " + in_quotes(local) + ", which is no model");
    }
    if (std::find(core_namespaces.begin(), core_namespaces.end(), name_space) ==
        core_namespaces.end()) {
      fail("a model in the namespace " + in_quotes(name_space) + ", which is not read");
    }
    core_ = name_space;
    model_.items.clear();
    model_.left_out = 0;
    read_unit(attributes);
    require_known_extensions(attributes);
  }

  void start_core(std::string_view name, const XmlAttributes& attributes) {
    if (name == "vertex") {
      read_vertex(attributes);
    } else if (name == "triangle") {
      read_triangle(attributes);
    } else if (name == "object") {
      start_object(attributes);
    } else if (name == "mesh" || name == "components") {
      open_object().has_geometry = true;
    } else if (name == "component") {
      read_component(attributes);
    } else if (name == "item") {
      read_item(attributes);
    } else if (name == "metadata" && open_) {
      flag_ = attributes.find("name").value_or("");
    }
  }

  void end(std::string_view name) {
    const auto [name_space, local] = parted(name);
    if (local == "metadata" || local == "setting") {
      end_flag();
    } else if (core_ && name_space == *core_ && local == "object") {
      end_object();
    }
  }

  void require_known_extensions(const XmlAttributes& attributes) const {
    LineReader words(attributes.find("requiredextensions").value_or(""));
    words.next_line();
    for (auto word = words.next_word(); !word.empty(); word = words.next_word()) {
      const auto known = prefixes_.find(std::string(word));
      const std::string name_space = known == prefixes_.end() ? "" : known->second;
      if (std::find(harmless.begin(), harmless.end(), name_space) == harmless.end()) {
        fail("needs the 3MF extension " + in_quotes(word) +
             (name_space.empty() ? "" : " (" + name_space + ")") + ", which is not read");
      }
    }
  }

  void start_object(const XmlAttributes& attributes) {
    if (open_) {
      fail("an object inside an object");
    }
    open_ = ThreeMfObject{};
    mesh_ = {};
    volumes_.clear();
    id_ = index(attributes, "id");
    open_->name = attributes.find("name").value_or("");
    const std::string_view type = attributes.find("type").value_or("model");
    open_->printed = type != "support" && type != "solidsupport" && type != "other";
    if (attributes.find(mesh_resolution).value_or("fullres") == "lowres") {
      fail("object " + std::to_string(id_) +
           " is given in slices (3MF slice extension), and its mesh only roughly");
    }
  }

  ThreeMfObject& open_object() {
    if (!open_) {
      fail("is outside of an object");
    }
    return *open_;
  }

  void read_volume(const XmlAttributes& attributes) {
    if (!attributes.find("ts") || !attributes.find("te")) {
      return;
    }
    volumes_.push_back({index(attributes, "ts"), index(attributes, "te"),
                        attributes.find("modifier").value_or("0") != "1"});
  }

  void read_text(std::string_view text) {
    constexpr std::size_t longest = 16;
    if (!flag_.empty()) {
      flag_value_ += text.substr(0, longest - std::min(flag_value_.size(), longest));
    }
  }

  void end_flag() {
    const std::string_view key =
        flag_.starts_with("cura:") ? std::string_view(flag_).substr(5) : std::string_view(flag_);
    const bool modifies = std::find(modifiers_of_cura.begin(), modifiers_of_cura.end(), key) !=
                          modifiers_of_cura.end();
    if (modifies && open_ &&
        (flag_value_ == "True" || flag_value_ == "true" || flag_value_ == "1")) {
      open_->printed = false;
    }
    flag_.clear();
    flag_value_.clear();
  }

  void end_object() {
    ThreeMfObject& object = open_object();
    if (object.printed) {
      const auto volumes = settings_.volumes.find(id_);
      object.bodies = printed_pieces(
          std::move(mesh_), volumes == settings_.volumes.end() ? volumes_ : volumes->second);
    }
    std::erase_if(object.bodies, [](const TriangleMesh& body) { return body.triangles.empty(); });
    for (const TriangleMesh& body : object.bodies) {
      object.uses = sum(object.uses, 1);
      object.triangles = sum(object.triangles, body.triangles.size());
    }
    if (!model_.objects.emplace(ThreeMfKey(part_, id_), std::move(object)).second) {
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
    const std::string_view whole = text(attributes, name);
    const std::string_view word = whole.substr(whole.starts_with('+') ? 1 : 0);
    std::uint32_t value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
      fail(in_quotes(whole) + " is no index");
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
        fail(in_quotes(word) + " is no number");
      }
      point[axis] = *value;
    }
    open_object();
    mesh_.vertices.push_back(point);
  }

  void read_triangle(const XmlAttributes& attributes) {
    const Triangle triangle{index(attributes, "v1"), index(attributes, "v2"),
                            index(attributes, "v3")};
    open_object();
    const std::uint32_t highest = *std::max_element(triangle.begin(), triangle.end());
    if (highest >= mesh_.vertices.size()) {
      fail("there is no vertex " + std::to_string(highest));
    }
    mesh_.triangles.push_back(triangle);
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
      fail(in_quotes(name) + " is no unit");
    }
    model_.unit = in_place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      model_.unit[axis][axis] = unit->second;
    }
  }

  // Depths and counts add up here, so that what is too much is refused before it is placed.
  void read_component(const XmlAttributes& attributes) {
    ThreeMfObject& object = open_object();
    if (++model_.components > limits_.components) {
      fail("more than " + std::to_string(limits_.components) + " components");
    }
    const ThreeMfUse component = use(attributes);
    const ThreeMfObject& inner = model_.objects.at(component.object);
    object.depth = std::max(object.depth, inner.depth + 1);
    if (object.depth > limits_.depth) {
      fail("nests objects in objects more than " + std::to_string(limits_.depth) + " deep");
    }
    if (!inner.printed || settings_.unprinted_components.contains({id_, component.object.second})) {
      return;
    }
    object.uses = sum(object.uses, inner.uses);
    object.triangles = sum(object.triangles, inner.triangles);
    object.components.push_back(component);
  }

  void read_item(const XmlAttributes& attributes) {
    if (model_.items.size() + model_.left_out >= limits_.items) {
      fail("more than " + std::to_string(limits_.items) + " items in the build");
    }
    const ThreeMfUse item = use(attributes);
    const ThreeMfObject& object = model_.objects.at(item.object);
    if (!object.has_geometry) {
      fail("object " + std::to_string(item.object.second) + " has neither a mesh nor components");
    }
    const std::string_view printable = attributes.find("printable").value_or("1");
    if (object.printed && printable != "0" && printable != "false") {
      model_.items.push_back(item);
    } else {
      ++model_.left_out;
    }
  }

  ThreeMfUse use(const XmlAttributes& attributes) const {
    const auto elsewhere = attributes.find(path_elsewhere);
    ThreeMfUse use{{elsewhere ? part_name(*elsewhere) : part_, index(attributes, "objectid")},
                   in_place};
    // Objects that are defined before they are used cannot contain themselves.
    if (model_.objects.count(use.object) == 0) {
      fail("there is no object " + std::to_string(use.object.second) +
           (elsewhere ? " in " + in_quotes(*elsewhere) : " before it"));
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
        const std::optional<double> value = float64_of(line.next_word());
        if (!value) {
          fail("a transform needs twelve numbers");
        }
        number = *value;
      }
    }
  }

  const std::filesystem::path& file_;
  std::string part_;
  const SlicerSettings& settings_;
  const MeshLimits& limits_;
  ThreeMfModel& model_;
  XmlReader xml_;
  std::map<std::string, std::string> prefixes_;
  std::optional<std::string> core_;  ///< the model's namespace
  std::optional<ThreeMfObject> open_;
  TriangleMesh mesh_;                  ///< of the open object
  std::vector<SlicerVolume> volumes_;  ///< of the open object, as Slic3r has them in the model
  std::uint32_t id_ = 0;
  std::string flag_;  ///< the setting whose value is being read
  std::string flag_value_;
};

ThreeMfModelReader::ThreeMfModelReader(const std::filesystem::path& file, std::string_view part,
                                       const SlicerSettings& settings, const MeshLimits& limits,
                                       ThreeMfModel& model)
    : events_(std::make_unique<Events>(file, part, settings, limits, model)) {}

ThreeMfModelReader::~ThreeMfModelReader() = default;

void ThreeMfModelReader::read(std::string_view piece) {
  events_->read(piece);
}

void ThreeMfModelReader::finish() {
  events_->finish();
}

}  // namespace latticast
