// SPDX-License-Identifier: GPL-3.0-or-later
// The example designs' meshes through every file format: what is read is what was written.
#include "export/mesh/mesh_formats.h"

#include <gtest/gtest.h>

#include "app/mold_set.h"
#include "app/plan.h"
#include "design/material_library.h"
#include "design/read_design.h"
#include "export/mesh/glb_file.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/tube_solids.h"
#include "molds/print_size.h"
#include "prepared/prepared_design.h"
#include "tests/unit/export/mesh/compare_meshes.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

Design example(const std::string& name) {
  const ReadResult read = read_design_file(
      std::filesystem::path(LATTICAST_SOURCE_DIR) / "examples" / name, built_in_materials());
  EXPECT_TRUE(read.ok());
  return read.design;
}

void expect_kept(const std::string& what, const TriangleMesh& mesh) {
  SCOPED_TRACE(what);
  const TestFolder folder;
  for (const auto& [format, name, suffix] : mesh_format_names) {
    SCOPED_TRACE(name);
    const auto file = folder / ("part" + std::string(suffix));
    write_mesh(file, mesh, format);
    const TriangleMesh read = read_mesh(file);
    expect_same_corners(read, mesh);
    if (!mesh_file_format(format).keeps_vertex_numbers) {
      // Its triangles share no vertices; welding finds the shared ones again.
      EXPECT_EQ(weld(read).vertices.size(), weld(mesh).vertices.size());
    } else {
      expect_same_mesh(read, mesh);
    }
  }
}

TEST(MeshFormats, KeepTheLatticesOfExamples) {
  for (const std::string name : {"twisting/twisting.toml", "twisting/two_families.toml",
                                 "bending/bending.toml", "superimposed/superimposed.toml"}) {
    const Design design = example(name);
    expect_kept(name, lattice_solid(design.segments.front(), {design.output.tolerance_mm}).mesh);
    expect_kept(name, liner_solid(design.segments.front(), {design.output.tolerance_mm}).mesh);
  }
}

TEST(MeshFormats, KeepThePiecesOfAMold) {
  const Design design = example("molds/twisting_molds.toml");
  PreparedDesign prepared(design);
  for (const PlannedMold& planned : plan_molds(prepared, plan_build(design, {}))) {
    for (const MoldPiece& piece : planned.mold.pieces) {
      expect_kept(planned.kind + " " + piece.name, printing_pose(piece));
    }
  }
}

}  // namespace
}  // namespace latticast
