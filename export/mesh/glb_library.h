// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 library (tinygltf), set up to work on bytes alone: it opens no files and decodes no
// pictures. Debian builds its shared library with both, so glb_library.cpp compiles the header's
// implementation instead of linking to it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace latticast {

/// The model as a binary glTF file. Throws std::invalid_argument for a name that is not UTF-8.
std::string encode_glb_model(tinygltf::Model& model);

/// The extensions that a glTF description names.
struct GltfExtensions {
  std::vector<std::string> used;
  std::vector<std::string> required;
};

/// Those of a description as JSON; none where it cannot be read. The library tells them only of
/// files that it can load. Precondition: nested no deeper than readers that call themselves follow.
GltfExtensions gltf_extensions(std::string_view json);

}  // namespace latticast
