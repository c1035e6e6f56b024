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

}  // namespace latticast
