// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "export/mesh/glb_file.h"
#include "export/mesh/glb_library.h"
#include "export/mesh/little_endian.h"
#include "export/mesh/mesh_checks.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

using Vector = std::array<float, 3>;

/// Columns after one another: x to x, y to -z, z to y, a thousandth of each.
const std::vector<double> metres_y_up{0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};

double linear_light(double srgb) {
  const double x = srgb > 0 ? std::min(srgb, 1.0) : 0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

tinygltf::Material material_of(const SceneBody& body) {
  tinygltf::Material material;
  material.name = body.name;
  material.pbrMetallicRoughness.baseColorFactor = {linear_light(body.colour.red),
                                                   linear_light(body.colour.green),
                                                   linear_light(body.colour.blue), 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  return material;
}

std::vector<Vector> rounded(const std::vector<Point>& points) {
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Point& p : points) {
    result.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  return result;
}

std::vector<Vector> differences(const std::vector<Point>& points, const std::vector<Vector>& rest) {
  std::vector<Vector> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[i][axis] = static_cast<float>(points[i][axis] - double{rest[i][axis]});
    }
  }
  return result;
}

/// By less than a body's coordinates can tell.
bool stays(const std::vector<Point>& rest, const std::vector<Point>& moved) {
  double largest = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < std::min(rest.size(), moved.size()); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      largest = std::max(largest, std::abs(rest[i][axis]));
      farthest = std::max(farthest, std::abs(moved[i][axis] - rest[i][axis]));
    }
  }
  return farthest <= 1e-7 * largest;
}

/// For each target of the bodies, whether it moves one of them.
std::vector<bool> moving_targets(const Scene& scene) {
  std::vector<bool> moving;
  for (const SceneBody& body : scene.bodies) {
    if (moving.size() < body.targets.size()) {
      moving.resize(body.targets.size(), false);
    }
    for (std::size_t i = 0; i < body.targets.size(); ++i) {
      moving[i] = moving[i] || !stays(body.mesh.vertices, body.targets[i].positions);
    }
  }
  return moving;
}

constexpr std::size_t at_rest = std::numeric_limits<std::size_t>::max();

/// From rest through all states and back: the numbers of stored targets.
std::vector<std::size_t> keyframes(const std::vector<bool>& moving) {
  std::vector<std::size_t> frames{at_rest};
  std::size_t stored = 0;
  for (const bool moves : moving) {
    if (moves) {
      frames.push_back(stored++);
    } else if (frames.back() != at_rest) {
      frames.push_back(at_rest);
    }
  }
  const std::size_t turning = frames.size() - 1;
  for (std::size_t i = turning; i-- > 0;) {
    frames.push_back(frames[i]);
  }
  return frames;
}

class SceneWriter {
 public:
  std::string write(const Scene& scene) {
    start();
    moving_ = moving_targets(scene);
    for (const SceneBody& body : scene.bodies) {
      add_body(body);
    }
    if (scene.animated) {
      add_animation(scene);
    }
    if (buffer().size() > std::numeric_limits<std::uint32_t>::max() / 2) {
      throw std::invalid_argument("a scene that is too large for a GLB file");
    }
    return encode_glb_model(model_);
  }

 private:
  std::vector<unsigned char>& buffer() { return model_.buffers.front().data; }

  void start() {
    model_.asset.version = "2.0";
    model_.asset.generator = "latticast " LATTICAST_VERSION;
    model_.buffers.emplace_back();
    tinygltf::Node root;
    root.name = "actuator";
    root.matrix = metres_y_up;
    model_.nodes.push_back(root);
    tinygltf::Scene scene;
    scene.nodes = {0};
    model_.scenes.push_back(scene);
    model_.defaultScene = 0;
  }

  /// Room for `count` numbers of four bytes, with a view and an accessor of its own.
  char* add_numbers(std::size_t count, int target, tinygltf::Accessor accessor) {
    const std::size_t offset = buffer().size();
    buffer().resize(offset + 4 * count);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = offset;
    view.byteLength = 4 * count;
    view.target = target;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    model_.bufferViews.push_back(view);
    model_.accessors.push_back(std::move(accessor));
    return reinterpret_cast<char*>(buffer().data() + offset);
  }

  int last_accessor() const { return static_cast<int>(model_.accessors.size()) - 1; }

  int add_positions(const std::vector<Vector>& positions) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.count = positions.size();
    accessor.minValues.assign(positions.front().begin(), positions.front().end());
    accessor.maxValues = accessor.minValues;
    for (const Vector& position : positions) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        accessor.minValues[axis] = std::min<double>(accessor.minValues[axis], position[axis]);
        accessor.maxValues[axis] = std::max<double>(accessor.maxValues[axis], position[axis]);
      }
    }
    char* out = add_numbers(3 * positions.size(), TINYGLTF_TARGET_ARRAY_BUFFER, accessor);
    for (const Vector& position : positions) {
      for (const float x : position) {
        out = put_float32(out, x);
      }
    }
    return last_accessor();
  }

  int add_corners(const std::vector<Triangle>& triangles) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.count = 3 * triangles.size();
    char* out = add_numbers(accessor.count, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, accessor);
    for (const Triangle& triangle : triangles) {
      for (const std::uint32_t corner : triangle) {
        out = put_little_endian(out, corner, 4);
      }
    }
    return last_accessor();
  }

  int add_scalars(const std::vector<float>& values) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.count = values.size();
    accessor.minValues = {*std::min_element(values.begin(), values.end())};
    accessor.maxValues = {*std::max_element(values.begin(), values.end())};
    char* out = add_numbers(values.size(), 0, accessor);
    for (const float value : values) {
      out = put_float32(out, value);
    }
    return last_accessor();
  }

  void add_body(const SceneBody& body) {
    require_valid(body.mesh);
    require_finite(body.mesh.vertices);
    const int number = static_cast<int>(model_.meshes.size());
    const std::vector<Vector> rest = rounded(body.mesh.vertices);
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_positions(rest);
    primitive.indices = add_corners(body.mesh.triangles);
    primitive.material = number;
    tinygltf::Mesh mesh;
    mesh.name = body.name;
    add_targets(body, rest, mesh, primitive);
    mesh.primitives.push_back(primitive);
    model_.meshes.push_back(mesh);
    model_.materials.push_back(material_of(body));
    tinygltf::Node node;
    node.name = body.name;
    node.mesh = number;
    model_.nodes.front().children.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(node);
  }

  void add_targets(const SceneBody& body, const std::vector<Vector>& rest, tinygltf::Mesh& mesh,
                   tinygltf::Primitive& primitive) {
    if (body.targets.empty()) {
      return;
    }
    tinygltf::Value::Array names;
    for (std::size_t i = 0; i < body.targets.size(); ++i) {
      const MorphTarget& target = body.targets[i];
      if (target.positions.size() != rest.size()) {
        throw std::invalid_argument("a morph target without a position for each vertex");
      }
      require_finite(target.positions);
      if (!moving_[i]) {
        continue;
      }
      primitive.targets.push_back(
          {{"POSITION", add_positions(differences(target.positions, rest))}});
      names.emplace_back(target.name);
    }
    if (names.empty()) {
      return;
    }
    mesh.weights.assign(names.size(), 0.0);
    mesh.extras = tinygltf::Value(tinygltf::Value::Object{{"targetNames", tinygltf::Value(names)}});
  }

  /// Row i of the weights is keyframe i.
  tinygltf::AnimationSampler sampler(const std::vector<std::size_t>& frames, std::size_t targets,
                                     int times) {
    std::vector<float> weights(frames.size() * targets, 0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (frames[i] != at_rest) {
        weights[i * targets + frames[i]] = 1;
      }
    }
    tinygltf::AnimationSampler sampler;
    sampler.input = times;
    sampler.output = add_scalars(weights);
    sampler.interpolation = "LINEAR";
    return sampler;
  }

  void add_animation(const Scene& scene) {
    tinygltf::Animation animation;
    animation.name = "inflate";
    const std::vector<std::size_t> frames = keyframes(moving_);
    std::vector<float> seconds(frames.size());
    std::iota(seconds.begin(), seconds.end(), 0.0F);
    int times = -1;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const std::size_t targets = model_.meshes[i].weights.size();
      if (targets == 0) {
        continue;
      }
      if (targets != static_cast<std::size_t>(std::count(moving_.begin(), moving_.end(), true))) {
        throw std::invalid_argument("an animation of bodies with different numbers of states");
      }
      if (times < 0) {
        times = add_scalars(seconds);
      }
      tinygltf::AnimationChannel channel;
      channel.sampler = static_cast<int>(animation.samplers.size());
      channel.target_node = model_.nodes.front().children[i];
      channel.target_path = "weights";
      animation.samplers.push_back(sampler(frames, targets, times));
      animation.channels.push_back(channel);
    }
    if (!animation.channels.empty()) {
      model_.animations.push_back(animation);
    }
  }

  tinygltf::Model model_;
  std::vector<bool> moving_;  ///< targets that are stored
};

}  // namespace

std::string encode_glb(const Scene& scene) {
  if (scene.bodies.empty()) {
    throw std::invalid_argument("a scene without bodies");
  }
  return SceneWriter().write(scene);
}

void write_glb(const std::filesystem::path& file, const Scene& scene) {
  write_file_atomically(file, encode_glb(scene));
}

}  // namespace latticast
