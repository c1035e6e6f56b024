// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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

namespace latticast {
namespace {

/// Metres, y upward, to mm, z upward.
constexpr Placement millimetres_z_up{{{1000, 0, 0}, {0, 0, 1000}, {0, -1000, 0}, {0, 0, 0}}};

Placement rotation(double x, double y, double z, double w) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
           {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
           {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
           {0, 0, 0}}};
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

/// Numbers that lie at equal distances in the file's buffer.
struct Numbers {
  const char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, std::string_view bytes) : file_(file) {
    load(bytes);
  }

  TriangleMesh read() {
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
      const Placement here = placed(parent, placement_of(node));
      if (node.mesh >= 0) {
        append_mesh(at(model_.meshes, node.mesh, "mesh"), here);
      }
      add_nodes(node.children, here, waiting);
    }
    return std::move(mesh_);
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
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(&take_no_image, nullptr);
    loader.SetFsCallbacks({&refuse, &same_name, &refuse, &refuse, nullptr});
    std::string reason;
    if (!try_to_load(loader, bytes, reason)) {
      std::replace(reason.begin(), reason.end(), '\n', ' ');
      fail("cannot be read: " + reason);
    }
    for (const std::string& extension : model_.extensionsRequired) {
      if (!extension.starts_with("KHR_materials_") && extension != "KHR_texture_transform") {
        fail("needs the glTF extension " + extension);
      }
    }
  }

  static void add_nodes(const std::vector<int>& nodes, const Placement& parent,
                        std::vector<std::pair<int, Placement>>& waiting) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
      waiting.emplace_back(nodes[i], parent);
    }
  }

  Numbers numbers_of(const tinygltf::Accessor& accessor, std::size_t size) const {
    if (accessor.sparse.isSparse || accessor.bufferView < 0) {
      fail("has a sparse accessor, which is not read");
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
  std::size_t append_positions(const tinygltf::Primitive& primitive, const Placement& here) {
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
    if (numbers.count > std::numeric_limits<std::uint32_t>::max() - mesh_.vertices.size()) {
      fail("holds more vertices than a mesh can have");
    }
    for (std::size_t i = 0; i < numbers.count; ++i) {
      const char* const in = numbers.first + i * numbers.stride;
      const Point point{get_float32(in), get_float32(in + 4), get_float32(in + 8)};
      mesh_.vertices.push_back(placed(here, point));
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

  void append_mesh(const tinygltf::Mesh& mesh, const Placement& here) {
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
          primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        fail("has triangle strips or fans, which are not read");
      }
      if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
        continue;
      }
      const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
      const std::size_t count = append_positions(primitive, here);
      const std::vector<std::uint32_t> corners = corners_of(primitive, count);
      if (corners.size() % 3 != 0) {
        fail("has a triangle without three corners");
      }
      const bool turned = mirrors(here);
      for (std::size_t i = 0; i < corners.size(); i += 3) {
        mesh_.triangles.push_back({first + corners[i], first + corners[turned ? i + 2 : i + 1],
                                   first + corners[turned ? i + 1 : i + 2]});
      }
    }
  }

  const std::filesystem::path& file_;
  tinygltf::Model model_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh decode_glb(const std::filesystem::path& file, std::string_view bytes) {
  return SceneReader(file, bytes).read();
}

}  // namespace latticast
