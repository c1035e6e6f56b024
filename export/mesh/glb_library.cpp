// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>  // which the header uses but includes only with its ways to files

#define TINYGLTF_IMPLEMENTATION
#include "export/mesh/glb_library.h"
