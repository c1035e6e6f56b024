// SPDX-License-Identifier: GPL-3.0-or-later
// The strains that colour a mesh, against those that `latticast check` compares with limits.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "checks/load_checks.h"
#include "checks/loaded_segment.h"
#include "design/material_library.h"
#include "design/read_design.h"
#include "geometry/solid/tube_solids.h"
#include "model/shape/strand_strain.h"

namespace latticast {
namespace {

constexpr double start_z_mm = 40;
constexpr double tolerance_mm = 0.05;

// One segment of a design under the largest pressure that it is loaded with, of materials that tear
// at once: every strain is then a finding.
Design fragile(const Design& design, std::size_t segment) {
  Design alone = design;
  alone.segments = {design.segments[segment]};
  alone.segments[0].liner.material.elongation_at_break = 1e-9;
  alone.segments[0].lattice->material.elongation_at_break = 1e-9;
  double largest = 0;
  for (const LoadCase& load : design.load) {
    largest = std::max(largest, load.pressures_kpa[segment]);
  }
  alone.load = {{{largest}}};
  return alone;
}

double worst(const CheckFindings& findings, std::string_view code) {
  double value = 0;
  for (const CheckFinding& finding : findings) {
    if (finding.code == code) value = std::max(value, finding.value.value_or(0));
  }
  return value;
}

double largest_of(const std::vector<double>& strains) {
  return *std::max_element(strains.begin(), strains.end());
}

// A vertex lies beside its straight strand's line by half of the width at most, where bending
// differs.
double beside_line(const Segment& segment, const State& state) {
  double bound = 0;
  for (const Grid& grid : segment.lattice->grids) {
    if (is_curved(grid.path)) continue;
    const double width = *std::max_element(grid.widths_mm.begin(), grid.widths_mm.end());
    const double half = 0.5 * width / std::sin(grid.angle_deg * std::numbers::pi / 180);
    bound = std::max(bound, half / segment.lattice_mid_radius_mm());
  }
  return bound * state.bend_magnitude_rad_per_mm() * state.outer_radius_mm;
}

void expect_the_checks_strains(const Design& design) {
  const Segment& segment = design.segments[0];
  PreparedResponses responses(design);
  const LoadedSegment loaded = load_segment(responses, 0);
  const CheckFindings findings = load_checks(responses);
  const SolidOptions options{tolerance_mm, start_z_mm, 0, 1};
  const TriangleMesh lattice = lattice_solid(segment, options).mesh;
  const TriangleMesh liner = liner_solid(segment, options).mesh;
  const StrandField field = strand_field(segment, lattice, start_z_mm, tolerance_mm);
  double strand = 0;
  double wall = 0;
  double bound = 0;
  double bent = 0;
  for (const State* state : loaded.states()) {
    const std::vector<double> strains = strand_strains(field, *state);
    ASSERT_EQ(strains.size(), lattice.vertices.size());
    strand = std::max(strand, largest_of(strains));
    wall =
        std::max(wall, largest_of(liner_strains(segment, liner, start_z_mm, tolerance_mm, *state)));
    bound = std::max(bound, beside_line(segment, *state));
    bent = std::max(bent, state->bend_magnitude_rad_per_mm());
  }
  const double checked = worst(findings, "strand-overstrained");
  const double checked_wall = worst(findings, "liner-overstrained");
  std::printf("  strands %.6f, checked %.6f (bending within %.6f); liner %.6f, checked %.6f\n",
              strand, checked, bound, wall, checked_wall);
  ASSERT_GT(checked, 0);
  EXPECT_NEAR(strand, checked, 1e-9 + bound);
  ASSERT_GT(checked_wall, 0);
  // Under bending no corner of a column need lie on the most lengthened side.
  EXPECT_NEAR(wall, checked_wall, 1e-9 + (bent > 0 ? 0.003 * checked_wall : 0));
}

TEST(StrandField, OfTheExamplesIsAsLargeAsTheirChecksSay) {
  int tried = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(LATTICAST_SOURCE_DIR) / "examples")) {
    if (entry.path().extension() != ".toml") continue;
    const ReadResult read = read_design_file(entry.path(), built_in_materials());
    ASSERT_TRUE(read.ok());
    for (std::size_t s = 0; s < read.design.segments.size(); ++s) {
      SCOPED_TRACE(entry.path().filename().string() + " segment " + std::to_string(s + 1));
      std::printf("%s, segment %zu\n", entry.path().filename().c_str(), s + 1);
      if (!read.design.segments[s].lattice || read.design.load.empty()) continue;
      expect_the_checks_strains(fragile(read.design, s));
      ++tried;
    }
  }
  EXPECT_GE(tried, 8);
}

}  // namespace
}  // namespace latticast
