// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_object.h"

#include <gtest/gtest.h>

namespace latticast {
namespace {

const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(MeshObject, IsCalledByItsNameOrItsPlace) {
  const std::vector<MeshObject> objects{
      {"left", {}}, {"", {}}, {"a\x1b[2Jb\n", {}}, {std::string(1000, 'n'), {}}};
  EXPECT_EQ(title_of(objects, 0), "\"left\"");
  EXPECT_EQ(title_of(objects, 1), "object 2");
  EXPECT_EQ(title_of(objects, 2), "\"a?[2Jb?\"");
  EXPECT_LT(title_of(objects, 3).size(), 80U);
}

TEST(MeshObject, SeveralBecomeOneMeshInTheirOrder) {
  const TriangleMesh whole =
      joined(std::vector<MeshObject>{{"a", triangle}, {"b", {}}, {"c", triangle}});
  EXPECT_EQ(whole.vertices.size(), 6U);
  EXPECT_EQ(whole.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(joined(std::vector<MeshObject>{}).triangles.empty());
}

}  // namespace
}  // namespace latticast
