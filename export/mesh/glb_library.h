// SPDX-License-Identifier: GPL-3.0-or-later
// tinygltf, without its ways to the world outside the bytes: no files, no pictures. Debian's shared
// library is built with others, so that glb_library.cpp compiles the header's own code.
#pragma once

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
