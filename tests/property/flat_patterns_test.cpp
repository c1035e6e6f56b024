// SPDX-License-Identifier: GPL-3.0-or-later
// Flat patterns of designs as strangers write them, against the solids of the same designs.
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "design/material_library.h"
#include "design/read_design.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/flat_pattern.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/tube_solids.h"
#include "tests/property/random_design_text.h"
#include "tests/unit/geometry/solid/flat_pattern_rules.h"

namespace latticast {
namespace {

constexpr std::uint64_t seed = 61241234;
constexpr int shards = 2;
constexpr int designs_per_shard = 40;

struct Tally {
  int sheets = 0;
  int with_arcs = 0;
  int refused = 0;
  double largest_difference = 0;  // of areas, as a part of what is allowed
};

// At this tolerance arcs and fillets have about as many chords as those of the solid.
double matching_tolerance_mm(const Segment& segment, double tolerance_mm) {
  return 0.5 * tolerance_mm * segment.lattice_mid_radius_mm() / segment.outer_radius_mm();
}

void expect_the_solids_area(const Segment& segment, const FlatPattern& sheet, const Solid& solid,
                            Tally& tally) {
  const double inner = segment.liner_outer_radius_mm();
  const double outer = segment.outer_radius_mm();
  const double height = (outer * outer - inner * inner) / (2 * sheet.radius_mm);
  const double allowed = sheet.error.area_mm2 + solid.error.volume_mm3 / height;
  const double difference = std::abs(sheet.area_mm2 - solid.volume_mm3 / height);
  EXPECT_LE(difference, allowed + 1e-12 * sheet.area_mm2);
  if (allowed > 0) {
    tally.largest_difference = std::max(tally.largest_difference, difference / allowed);
  }
  // A piece of the tube may be slit into several, never the other way round.
  EXPECT_GE(static_cast<int>(sheet.pieces.size()), solid.pieces);
}

void try_segment(const Segment& segment, double tolerance_mm, Tally& tally) {
  const double matching = matching_tolerance_mm(segment, tolerance_mm);
  FlatPattern sheet;
  try {
    const Solid solid = lattice_solid(segment, {tolerance_mm, 0, 0, 1});
    sheet = flat_pattern(segment, matching);
    expect_the_solids_area(segment, sheet, solid, tally);
  } catch (const CannotDraw&) {
    ++tally.refused;
    return;
  } catch (const GeometryError&) {
    ++tally.refused;
    return;
  }
  ASSERT_NO_FATAL_FAILURE(expect_sound_sheet(segment, sheet, matching));
  ++tally.sheets;
  for (const Grid& grid : segment.lattice->grids) tally.with_arcs += is_curved(grid.path);
}

class FlatPatterns : public testing::TestWithParam<int> {};

TEST_P(FlatPatterns, HaveTheSolidsAreaAndTheTrianglesTopology) {
  Tally tally;
  const std::uint64_t first = seed + static_cast<std::uint64_t>(GetParam() * designs_per_shard);
  for (int i = 0; i < designs_per_shard; ++i) {
    const DesignText design = random_design_text(first + i);
    SCOPED_TRACE("seed " + std::to_string(first + i) + ":\n" + design.text);
    const ReadResult read = read_design(design.text, built_in_materials());
    if (!read.ok()) continue;
    for (const Segment& segment : read.design.segments) {
      if (!segment.lattice) continue;
      ASSERT_NO_FATAL_FAILURE(try_segment(segment, read.design.output.tolerance_mm, tally));
    }
  }
  std::printf(
      "seeds from %llu: %d sheets, %d families of arcs, %d refused; areas differ by %.2g of "
      "what is allowed at most\n",
      static_cast<unsigned long long>(first), tally.sheets, tally.with_arcs, tally.refused,
      tally.largest_difference);
  EXPECT_GE(tally.sheets, designs_per_shard / 2);
}

INSTANTIATE_TEST_SUITE_P(Shards, FlatPatterns, testing::Range(0, shards));

}  // namespace
}  // namespace latticast
