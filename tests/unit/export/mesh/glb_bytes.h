// SPDX-License-Identifier: GPL-3.0-or-later
// GLB files made for tests, as other programs might write them.
#pragma once

#include <array>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

namespace latticast {

using Json = nlohmann::json;

inline std::string uint32_bytes(std::size_t number) {
  const auto value = static_cast<std::uint32_t>(number);
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

/// A GLB file of this JSON and binary data, as another program might write it.
inline std::string glb(const Json& json, std::string data) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  data.resize((data.size() + 3) / 4 * 4, '\0');
  return "glTF" + uint32_bytes(2) + uint32_bytes(28 + text.size() + data.size()) +
         uint32_bytes(text.size()) + "JSON" + text + uint32_bytes(data.size()) +
         std::string("BIN\0", 4) + data;
}

/// One triangle (1, 2, 3), (4, 2, 3), (1, 5, 3) in metres.
inline std::string three_points() {
  const std::array<float, 9> points{1, 2, 3, 4, 2, 3, 1, 5, 3};
  return {reinterpret_cast<const char*>(points.data()), sizeof points};
}

inline Json triangle_json() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [1, 2, 3], "max": [4, 5, 3]}]})");
}

}  // namespace latticast
