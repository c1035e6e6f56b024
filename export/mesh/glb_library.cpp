// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>  // which the header uses but includes only with its ways to files

#define TINYGLTF_IMPLEMENTATION
#include <sstream>
#include <stdexcept>
#include <utility>

#include "export/mesh/glb_library.h"

namespace latticast {

// Here, because the library's exceptions are those of nlohmann-json, which takes seconds to
// compile.
std::string encode_glb_model(tinygltf::Model& model) {
  std::ostringstream stream;
  try {
    if (tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true)) {
      return std::move(stream).str();
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("a scene with a bad name: ") + error.what());
  }
  throw std::runtime_error("a scene that cannot be put into GLB");
}

GltfExtensions gltf_extensions(std::string_view json) {
  const auto description = nlohmann::json::parse(json.begin(), json.end(), nullptr, false);
  GltfExtensions extensions;
  const auto collect = [&](const char* key, std::vector<std::string>& names) {
    if (!description.is_object() || !description.contains(key)) return;
    for (const auto& name : description[key]) {
      if (name.is_string()) names.push_back(name.get<std::string>());
    }
  };
  collect("extensionsUsed", extensions.used);
  collect("extensionsRequired", extensions.required);
  return extensions;
}

}  // namespace latticast
