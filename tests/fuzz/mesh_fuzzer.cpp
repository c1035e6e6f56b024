// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds bytes to the readers of STL, OBJ, PLY, GLB and OFF; the first byte chooses which. What they
// accept must be a mesh that can be welded, and written and read again without a change.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "export/mesh/obj_file.h"
#include "export/mesh/off_file.h"
#include "export/mesh/ply_file.h"
#include "export/mesh/stl_file.h"
#include "geometry/mesh/weld.h"

namespace {

using namespace latticast;

void require(bool promise) {
  if (!promise) std::abort();
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

void require_same_corners(const TriangleMesh& a, const TriangleMesh& b) {
  require(a.triangles.size() == b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const Point& p = a.vertices[a.triangles[i][corner]];
      const Point& q = b.vertices[b.triangles[i][corner]];
      require(same(p[0], q[0]) && same(p[1], q[1]) && same(p[2], q[2]));
    }
  }
}

void require_valid(const TriangleMesh& mesh) {
  require(!mesh.triangles.empty());
  for (const Triangle& triangle : mesh.triangles) {
    require(*std::max_element(triangle.begin(), triangle.end()) < mesh.vertices.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr std::array names{"fuzzed.stl", "fuzzed.obj", "fuzzed.ply", "fuzzed.glb", "fuzzed.off"};
  TriangleMesh mesh;
  try {
    mesh = read_mesh_bytes(names[data[0] % names.size()], bytes);
  } catch (const FileError&) {
    return 0;
  }
  require_valid(mesh);
  require_valid(weld(mesh));
  require_same_corners(mesh, read_mesh_bytes("again.stl", encode_stl(mesh)));
  require_same_corners(mesh, read_mesh_bytes("again.obj", encode_obj(mesh)));
  require_same_corners(mesh, read_mesh_bytes("again.off", encode_off(mesh)));
  require_same_corners(mesh, read_mesh_bytes("again.ply", encode_ply(mesh)));
  return 0;
}
