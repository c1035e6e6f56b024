// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "design/file_error.h"
#include "export/mesh/glb_file.h"
#include "export/mesh/glb_library.h"
#include "export/mesh/little_endian.h"
#include "export/mesh/placement.h"
#include "geometry/mesh/weld.h"

namespace latticast {
namespace {

/// Metres, y upward, to mm, z upward.
constexpr Placement millimetres_z_up{{{1000, 0, 0}, {0, 0, 1000}, {0, -1000, 0}, {0, 0, 0}}};

// Beside these, materials and textures of any kind leave meshes as they are.
constexpr std::array<std::string_view, 6> harmless{"EXT_mesh_gpu_instancing",  // which is read
                                                   "KHR_node_visibility",      // likewise
                                                   "KHR_lights_punctual",     "KHR_xmp_json_ld",
                                                   "KHR_animation_pointer",   "MSFT_texture_dds"};

bool is_harmless(std::string_view extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("EXT_materials_") ||
         extension.starts_with("KHR_texture_") || extension.starts_with("EXT_texture_") ||
         std::find(harmless.begin(), harmless.end(), extension) != harmless.end();
}

/// Whether meshes without what the extension adds are others, by its name.
bool changes_meshes(std::string_view extension) {
  constexpr std::array<std::string_view, 5> words{"instancing", "displacement", "subdivision",
                                                  "tessellation", "meshopt"};
  return !is_harmless(extension) &&
         std::any_of(words.begin(), words.end(), [&](std::string_view word) {
           return extension.find(word) != std::string_view::npos;
         });
}

bool is_compression(std::string_view extension) {
  return extension.find("compression") != std::string_view::npos;
}

Placement rotation(double x, double y, double z, double w) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
           {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
           {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
           {0, 0, 0}}};
}

/// First a scaling, then a rotation by a quaternion, then a shift.
Placement placement_of(const Point& shift, const std::array<double, 4>& turn, const Point& scale) {
  Placement result = rotation(turn[0], turn[1], turn[2], turn[3]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t row = 0; row < 3; ++row) result[axis][row] *= scale[axis];
  }
  result[3] = shift;
  return result;
}

/// The node's own placement: a matrix, or a scaling, then a rotation by a quaternion, then a shift.
Placement placement_of(const tinygltf::Node& node) {
  Placement result = in_place;
  if (node.matrix.size() == 16) {
    for (std::size_t i = 0; i < 16; ++i) {
      if (i % 4 < 3) {
        result[i / 4][i % 4] = node.matrix[i];
      }
    }
    return result;
  }
  if (node.rotation.size() == 4) {
    result = rotation(node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t row = 0; row < 3 && node.scale.size() == 3; ++row) {
      result[axis][row] *= node.scale[axis];
    }
    if (node.translation.size() == 3) {
      result[3][axis] = node.translation[axis];
    }
  }
  return result;
}

/// Whether JSON nests no deeper than readers that call themselves can follow.
bool is_shallow(std::string_view json) {
  constexpr int deepest = 100;
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      in_text = !in_text;
    } else if (in_text) {
      i += c == '\\' ? 1 : 0;
    } else if ((c == '{' || c == '[') && ++depth > deepest) {
      return false;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return true;
}

// What the loader may ask of the world outside the bytes.
template <typename... Arguments>
bool refuse(Arguments... /*unused*/) {
  return false;
}

template <typename... Arguments>
bool take_no_image(Arguments... /*unused*/) {
  return true;
}

std::string same_name(const std::string& name, void* /*unused*/) {
  return name;
}

/// An integer of a component type as the number that it stands for: itself, or a fraction.
double fraction(std::int64_t value, bool normalised, double highest) {
  return normalised ? std::max(static_cast<double>(value) / highest, -1.0)
                    : static_cast<double>(value);
}

bool is_visible(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_node_visibility");
  if (found == node.extensions.end() || !found->second.Has("visible")) return true;
  const tinygltf::Value& visible = found->second.Get("visible");
  return !visible.IsBool() || visible.Get<bool>();
}

/// Numbers that lie at equal distances in the file's buffer.
struct Numbers {
  const char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, std::string_view bytes, const MeshLimits& limits)
      : file_(file), limits_(limits) {
    constexpr std::size_t least_bytes = 3;  // of a triangle: its corners, one byte each
    file_triangles_ = bytes.size() / least_bytes;
    load(bytes);
  }

  std::vector<MeshObject> read() {
    if (model_.scenes.empty()) {
      fail("holds no scene");
    }
    const int scene = std::max(model_.defaultScene, 0);
    std::vector<std::pair<int, Placement>> waiting;
    add_nodes(at(model_.scenes, scene, "scene").nodes, millimetres_z_up, waiting);
    std::vector<bool> seen(model_.nodes.size());
    while (!waiting.empty()) {
      const auto [number, parent] = waiting.back();
      waiting.pop_back();
      const tinygltf::Node& node = at(model_.nodes, number, "node");
      if (seen[number]) {
        fail("has a node with two parents");
      }
      seen[number] = true;
      if (!is_visible(node)) {
        continue;  // nor is what hangs below it
      }
      const Placement here = placed(parent, placement_of(node));
      if (node.mesh >= 0) {
        add_meshes(node, here);
      }
      add_nodes(node.children, here, waiting);
    }
    return std::move(objects_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(file_, reason); }

  template <typename Item>
  const Item& at(const std::vector<Item>& items, int number, const std::string& name) const {
    if (number < 0 || static_cast<std::size_t>(number) >= items.size()) {
      fail("names " + name + " " + std::to_string(number) + ", which it does not have");
    }
    return items[number];
  }

  void check_frame(std::string_view bytes) const {
    constexpr std::size_t frame = 20;
    if (bytes.size() < frame || !bytes.starts_with("glTF")) {
      fail("does not begin with a GLB header");
    }
    const std::uint64_t length = get_little_endian(bytes.data() + 8, 4);
    const std::uint64_t json_length = get_little_endian(bytes.data() + 12, 4);
    if (length != bytes.size() || json_length > bytes.size() - frame) {
      fail("says that it has " + std::to_string(length) + " bytes, but has " +
           std::to_string(bytes.size()));
    }
    if (!is_shallow(bytes.substr(frame, json_length))) {
      fail("nests its description too deeply");
    }
  }

  // On damaged files the loader lets through what its containers throw.
  bool try_to_load(tinygltf::TinyGLTF& loader, std::string_view bytes, std::string& reason) {
    std::string warning;
    try {
      return loader.LoadBinaryFromMemory(&model_, &reason, &warning,
                                         reinterpret_cast<const unsigned char*>(bytes.data()),
                                         static_cast<unsigned>(bytes.size()));
    } catch (const std::exception& error) {
      reason = error.what();
      return false;
    }
  }

  void load(std::string_view bytes) {
    check_frame(bytes);
    constexpr std::size_t frame = 20;
    extensions_ = gltf_extensions(bytes.substr(frame, get_little_endian(bytes.data() + 12, 4)));
    check_extensions();
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(&take_no_image, nullptr);
    loader.SetFsCallbacks({&refuse, &same_name, &refuse, &refuse, nullptr});
    std::string reason;
    if (!try_to_load(loader, bytes, reason)) {
      fail_if_compressed();
      std::replace(reason.begin(), reason.end(), '\n', ' ');
      fail("cannot be read: " + reason);
    }
  }

  [[noreturn]] void fail_for(const std::string& extension) const {
    fail("needs the glTF extension " + extension + ", which is not read" +
         (is_compression(extension) ? ": export it without compression" : ""));
  }

  void fail_if_compressed() const {
    for (const std::string& extension : extensions_.used) {
      if (is_compression(extension)) fail_for(extension);
    }
  }

  void check_extensions() const {
    for (const std::string& extension : extensions_.required) {
      if (!is_harmless(extension)) fail_for(extension);
    }
    for (const std::string& extension : extensions_.used) {
      if (changes_meshes(extension)) fail_for(extension);
    }
  }

  static void add_nodes(const std::vector<int>& nodes, const Placement& parent,
                        std::vector<std::pair<int, Placement>>& waiting) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
      waiting.emplace_back(nodes[i], parent);
    }
  }

  Numbers numbers_of(const tinygltf::Accessor& accessor, std::size_t size) const {
    if (accessor.sparse.isSparse) {
      fail("has a sparse accessor, which is not read");
    }
    if (accessor.bufferView < 0) {
      fail_if_compressed();
      fail("has an accessor without data");
    }
    const tinygltf::BufferView& view = at(model_.bufferViews, accessor.bufferView, "buffer view");
    const std::size_t held = at(model_.buffers, view.buffer, "buffer").data.size();
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    const bool inside = view.byteOffset <= held && view.byteLength <= held - view.byteOffset &&
                        accessor.byteOffset <= view.byteLength &&
                        size <= view.byteLength - accessor.byteOffset && stride >= size;
    if (!inside || accessor.count == 0 ||
        (view.byteLength - accessor.byteOffset - size) / stride < accessor.count - 1) {
      fail("has an accessor that reaches past its data");
    }
    const unsigned char* const data = model_.buffers[view.buffer].data.data();
    return {reinterpret_cast<const char*>(data) + view.byteOffset + accessor.byteOffset, stride,
            accessor.count};
  }

  /// Returns how many.
  std::size_t append_positions(const tinygltf::Primitive& primitive, const Placement& here,
                               TriangleMesh& mesh) const {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
      return 0;
    }
    const tinygltf::Accessor& accessor = at(model_.accessors, position->second, "accessor");
    if (accessor.type != TINYGLTF_TYPE_VEC3 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      fail("has positions that are not three float32");
    }
    const Numbers numbers = numbers_of(accessor, 12);
    if (numbers.count > std::numeric_limits<std::uint32_t>::max() - mesh.vertices.size()) {
      fail("holds more vertices than a mesh can have");
    }
    for (std::size_t i = 0; i < numbers.count; ++i) {
      const char* const in = numbers.first + i * numbers.stride;
      const Point point{get_float32(in), get_float32(in + 4), get_float32(in + 8)};
      mesh.vertices.push_back(placed(here, point));
    }
    return numbers.count;
  }

  std::vector<std::uint32_t> corners_of(const tinygltf::Primitive& primitive,
                                        std::size_t vertices) const {
    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < vertices; ++i) {
        corners.push_back(static_cast<std::uint32_t>(i));
      }
      return corners;
    }
    const tinygltf::Accessor& accessor = at(model_.accessors, primitive.indices, "accessor");
    const std::optional<std::size_t> size = size_of_index(accessor);
    if (!size) {
      fail("has vertex indices that are not integers of 8, 16 or 32 bits");
    }
    const Numbers numbers = numbers_of(accessor, *size);
    for (std::size_t i = 0; i < numbers.count; ++i) {
      const std::uint64_t corner = get_little_endian(numbers.first + i * numbers.stride, *size);
      if (corner >= vertices) {
        fail("has a face that names a vertex that it does not have");
      }
      corners.push_back(static_cast<std::uint32_t>(corner));
    }
    return corners;
  }

  static std::optional<std::size_t> size_of_index(const tinygltf::Accessor& accessor) {
    if (accessor.type != TINYGLTF_TYPE_SCALAR) {
      return std::nullopt;
    }
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return 4;
      default:
        return std::nullopt;
    }
  }

  /// A mesh of several materials has a primitive for each, which are open where they meet: they are
  /// one object. Primitives that are closed one and all are objects of their own.
  std::vector<TriangleMesh> placed_bodies(const tinygltf::Mesh& source,
                                          const Placement& here) const {
    std::vector<TriangleMesh> bodies;
    for (const tinygltf::Primitive& primitive : source.primitives) {
      if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
          primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        fail("has triangle strips or fans, which are not read");
      }
      if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
        continue;
      }
      append_triangles(primitive, here, bodies.emplace_back());
    }
    const bool apart = std::all_of(bodies.begin(), bodies.end(), [&](const TriangleMesh& body) {
      return bodies.size() == 1 || is_closed(weld(body));
    });
    if (!apart) {
      bodies = {joined(std::move(bodies))};
    }
    return bodies;
  }

  void append_triangles(const tinygltf::Primitive& primitive, const Placement& here,
                        TriangleMesh& mesh) const {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::size_t count = append_positions(primitive, here, mesh);
    const std::vector<std::uint32_t> corners = corners_of(primitive, count);
    if (corners.size() % 3 != 0) {
      fail("has a triangle without three corners");
    }
    const bool turned = mirrors(here);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      mesh.triangles.push_back({first + corners[i], first + corners[turned ? i + 2 : i + 1],
                                first + corners[turned ? i + 1 : i + 2]});
    }
  }

  /// The node's mesh where it stands, or its instances.
  void add_meshes(const tinygltf::Node& node, const Placement& here) {
    const tinygltf::Mesh& source = at(model_.meshes, node.mesh, "mesh");
    const std::string& name = node.name.empty() ? source.name : node.name;
    const auto instancing = node.extensions.find("EXT_mesh_gpu_instancing");
    if (instancing == node.extensions.end()) {
      add_objects(name, placed_bodies(source, here));
      return;
    }
    const Instances instances = instances_of(instancing->second);
    for (std::size_t i = 0; i < instances.count; ++i) {
      add_objects(name, placed_bodies(source, placed(here, instances.placement(*this, i))));
    }
  }

  // Each time anew: a first use of a mesh takes what the file takes, however large.
  void add_objects(const std::string& name, std::vector<TriangleMesh> bodies) {
    for (TriangleMesh& body : bodies) add_object(name, std::move(body));
  }

  void add_object(const std::string& name, TriangleMesh mesh) {
    if (mesh.triangles.empty()) return;
    triangles_ += mesh.triangles.size();
    const bool repeated = triangles_ > limits_.triangles && triangles_ > file_triangles_;
    if (objects_.size() >= limits_.uses || repeated) {
      fail("uses its meshes too many times: more than " + std::to_string(limits_.uses) +
           " times, or " + std::to_string(limits_.triangles) + " triangles");
    }
    objects_.push_back({name, std::move(mesh)});
  }

  /// Where the instances of a node stand; accessors are null where all have the usual value.
  struct Instances {
    const tinygltf::Accessor* shift = nullptr;
    const tinygltf::Accessor* turn = nullptr;
    const tinygltf::Accessor* scale = nullptr;
    std::size_t count = 0;

    Placement placement(const SceneReader& reader, std::size_t i) const {
      Point moved{0, 0, 0};
      std::array<double, 4> turned{0, 0, 0, 1};
      Point scaled{1, 1, 1};
      if (shift != nullptr) reader.read_item(*shift, i, moved);
      if (turn != nullptr) reader.read_item(*turn, i, turned);
      if (scale != nullptr) reader.read_item(*scale, i, scaled);
      return placement_of(moved, turned, scaled);
    }
  };

  Instances instances_of(const tinygltf::Value& extension) const {
    Instances instances;
    const auto find = [&](const char* name, int type, const tinygltf::Accessor*& accessor) {
      if (!extension.Has("attributes") || !extension.Get("attributes").Has(name)) return;
      const tinygltf::Value& number = extension.Get("attributes").Get(name);
      accessor =
          &at(model_.accessors, number.IsNumber() ? number.GetNumberAsInt() : -1, "accessor");
      if (accessor->type != type || (instances.count > 0 && instances.count != accessor->count)) {
        fail("has instances whose places contradict one another");
      }
      instances.count = accessor->count;
    };
    find("TRANSLATION", TINYGLTF_TYPE_VEC3, instances.shift);
    find("ROTATION", TINYGLTF_TYPE_VEC4, instances.turn);
    find("SCALE", TINYGLTF_TYPE_VEC3, instances.scale);
    if (instances.count == 0) {
      fail("has instances without places");
    }
    if (instances.count > limits_.uses) {
      fail("uses its meshes too many times: more than " + std::to_string(limits_.uses) + " times");
    }
    return instances;
  }

  /// Item `i` of an accessor of floats, or of small integers that stand for fractions.
  template <std::size_t Size>
  void read_item(const tinygltf::Accessor& accessor, std::size_t i,
                 std::array<double, Size>& item) const {
    const int size = tinygltf::GetComponentSizeInBytes(accessor.componentType);
    if (size != 1 && size != 2 && accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      fail("has instances whose places are no numbers of 8, 16 or 32 bits");
    }
    const auto width = static_cast<std::size_t>(size);
    const Numbers numbers = numbers_of(accessor, width * Size);
    for (std::size_t part = 0; part < Size; ++part) {
      const char* const in = numbers.first + i * numbers.stride + part * width;
      item[part] = number_at(in, accessor);
    }
  }

  static double number_at(const char* in, const tinygltf::Accessor& accessor) {
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return fraction(static_cast<std::int8_t>(get_little_endian(in, 1)), accessor.normalized,
                        127);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return fraction(static_cast<std::int64_t>(get_little_endian(in, 1)), accessor.normalized,
                        255);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return fraction(static_cast<std::int16_t>(get_little_endian(in, 2)), accessor.normalized,
                        32767);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return fraction(static_cast<std::int64_t>(get_little_endian(in, 2)), accessor.normalized,
                        65535);
      default:
        return get_float32(in);
    }
  }

  const std::filesystem::path& file_;
  MeshLimits limits_;
  GltfExtensions extensions_;
  tinygltf::Model model_;
  std::vector<MeshObject> objects_;
  std::size_t triangles_ = 0;       ///< of all objects
  std::size_t file_triangles_ = 0;  ///< that the file's bytes could hold
};

}  // namespace

std::vector<MeshObject> decode_glb(const std::filesystem::path& file, std::string_view bytes,
                                   const MeshLimits& limits) {
  return SceneReader(file, bytes, limits).read();
}

}  // namespace latticast
