// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 library (tinygltf), set up to work on bytes alone: it opens no files and decodes no
// pictures. Debian builds its shared library with both, so glb_library.cpp compiles the header's
// implementation instead of linking to it.
#pragma once

#include <string>

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace latticast {

/// The model as a binary glTF file. Throws std::invalid_argument for a name that is not UTF-8.
std::string encode_glb_model(tinygltf::Model& model);

}  // namespace latticast
