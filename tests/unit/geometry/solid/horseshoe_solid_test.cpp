// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of horseshoe columns and fillets.
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh/weld.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"
#include "tests/unit/geometry/solid/example_segments.h"
#include "tests/unit/geometry/solid/mesh_measures.h"
#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

// The radius with which so many arcs fill a segment.
double closing_radius(const Segment& segment, double angle_deg, double arc_deg, int arcs) {
  return segment.length_mm / std::sin(radians(angle_deg)) / arcs / 2 /
         std::sin(0.5 * radians(arc_deg));
}

// Horseshoes alone, without rings.
Segment columns(double angle_deg, double arc_deg, bool alternate, int arcs,
                std::vector<double> widths) {
  Segment segment = example_segment();
  segment.lattice->rings.reset();
  const double radius = closing_radius(segment, angle_deg, arc_deg, arcs);
  segment.lattice->grids = {{angle_deg, std::move(widths), Horseshoe{radius, arc_deg, alternate}}};
  return segment;
}

void expect_sound(const Solid& solid) {
  ASSERT_TRUE(is_closed_and_oriented(solid.mesh));
  EXPECT_EQ(genus(solid.mesh), solid.genus);
  EXPECT_EQ(components(solid.mesh), solid.pieces);
  const Audit result = audit(weld(solid.mesh));
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.components, solid.pieces);
  EXPECT_EQ(result.genus, solid.genus);
  EXPECT_NEAR(result.volume_mm3, solid.volume_mm3, solid.volume_bound_mm3);
}

TEST(HorseshoeSolid, HasTheVolumeOfItsArcs) {
  // w R arc per arc, times the layer's height: R_o^2 - R_m^2 over 2 R_c.
  for (const double arc : {40.0, 90.0, 170.0}) {
    for (const double tolerance : {0.1, 0.01}) {
      SCOPED_TRACE(testing::Message() << arc << " " << tolerance);
      const Segment segment = columns(90, arc, true, 16, {1, 2, 1.5});
      SolidOptions options;
      options.tolerance_mm = tolerance;
      const Solid solid = lattice_solid(segment, options);
      ASSERT_NO_FATAL_FAILURE(expect_sound(solid));
      const double radius = std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm;
      const double expected = 16 * radius * radians(arc) * (1 + 2 + 1.5) * 2;
      EXPECT_NEAR(solid.volume_mm3, expected, 1e-4 * expected);
      EXPECT_EQ(solid.pieces, 3);
      EXPECT_EQ(solid.genus, 0);
    }
  }
}

TEST(HorseshoeSolid, IsOnePieceAStrandAndNothingIsLeftAtTheEnds) {
  constexpr std::uint64_t seed = 8301;
  int made = 0;
  for (std::uint64_t i = 0; i < 150; ++i) {
    RandomNumbers random(seed + i);
    const bool alternate = random.whole(0, 2) > 0;
    const double angle = random.whole(0, 3) == 0 ? 90 : random.between(20, 160);
    const double arc = random.between(20, alternate ? 260 : 180);
    const int count = random.whole(1, 5);
    const Segment segment = columns(angle, arc, alternate, random.whole(1, 24),
                                    std::vector<double>(count, random.log_between(0.1, 4)));
    SCOPED_TRACE(testing::Message() << "seed " << seed + i << ": angle " << angle << " arc " << arc
                                    << " count " << count);
    if (!drawing_problems(segment).empty()) continue;
    SolidOptions options;
    options.tolerance_mm = random.log_between(0.005, 0.05);
    const Solid solid = lattice_solid(segment, options);
    ASSERT_NO_FATAL_FAILURE(expect_sound(solid));
    // Columns that overlap are nets, unless the segment ends before they meet.
    if (overlapping_neighbours(segment).empty()) {
      EXPECT_EQ(solid.pieces, count);
    } else {
      EXPECT_LE(solid.pieces, count);
    }
    ++made;
  }
  std::printf("seeds from %llu: %d of 150 drawn\n", static_cast<unsigned long long>(seed), made);
  EXPECT_GT(made, 60);
}

TEST(HorseshoeSolid, WithRingsAndOtherFamiliesPassesItsAudit) {
  constexpr std::uint64_t seed = 8501;
  int made = 0;
  for (std::uint64_t i = 0; i < 80; ++i) {
    RandomNumbers random(seed + i);
    Segment segment = random_segment(random);
    const double angle = random.whole(0, 2) == 0 ? 90 : random.between(25, 155);
    const double arc = random.whole(0, 2) == 0 ? 180 : random.between(30, 240);
    const double radius = closing_radius(segment, angle, arc, random.whole(1, 20));
    const double width = radius * random.log_between(0.05, 1.5);
    segment.lattice->grids.push_back({angle, std::vector<double>(random.whole(1, 8), width),
                                      Horseshoe{radius, arc, random.whole(0, 2) > 0}});
    if (random.whole(0, 1) == 0) {
      segment.lattice->fillet_mm = segment.lattice_mid_radius_mm() * random.log_between(0.002, 0.5);
    }
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    if (!drawing_problems(segment).empty()) continue;
    SolidOptions options;
    options.tolerance_mm = random.log_between(0.005, 0.05);
    options.start_z_mm = random.between(0, 200);
    ASSERT_NO_FATAL_FAILURE(expect_sound(lattice_solid(segment, options)));
    ++made;
  }
  std::printf("seeds from %llu: %d of 80 drawn\n", static_cast<unsigned long long>(seed), made);
  EXPECT_GT(made, 30);
}

// Arcs that touch ring edges, joints on ring centres, arcs that touch arcs.
TEST(HorseshoeSolid, OfTangentContactsPassesItsAudit) {
  for (const double fillet : {0.0, 0.05, 0.5}) {
    for (const double width : {0.5, 1.0, 2.0}) {
      Segment segment = columns(90, 180, true, 16, std::vector<double>(4, width));
      segment.lattice->fillet_mm = fillet;
      const double chord = 85.0 / 16;
      // Centres at half a pitch and so on: tops of arcs at z = chord/2 + R + w/2 touch ring edges
      // from below, and joints lie on ring centres, for these pitches.
      for (const double pitch : {2 * chord, chord, 4 * chord}) {
        segment.lattice->rings = Rings{std::nullopt, pitch, width};
        SCOPED_TRACE(testing::Message() << fillet << " " << width << " " << pitch);
        ASSERT_NO_FATAL_FAILURE(expect_sound(lattice_solid(segment, {})));
      }
      // Neighbours from either side that touch in a point: two families, half a turn apart.
      const double radius = std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm;
      segment.liner.inner_radius_mm =
          (4 * radius + 2 * width) * 4 / (2 * std::numbers::pi) - 1 - segment.liner.thickness_mm;
      segment.lattice->grids.push_back(segment.lattice->grids[0]);
      ASSERT_NO_FATAL_FAILURE(expect_sound(lattice_solid(segment, {})));
    }
  }
}

// An arc crosses a strip at half a degree: walls from their crossing are far closer to each other
// than the tolerance, in which each may leave its surface.
TEST(HorseshoeSolid, OfArcsThatGrazeStripsPassesItsAudit) {
  Segment segment = example_segment();
  segment.length_mm = 373.1999384;
  segment.liner = {10.07634491, 5.580498522, {}};
  segment.lattice->thickness_mm = 1.534923473;
  segment.lattice->rings.reset();
  segment.lattice->grids = {
      {98.19701245, std::vector<double>(8, 4.307772141), Horseshoe{7.41088668, 78.98490614, true}},
      {70,
       {1.25043072, 1.499656597, 1.25813911, 2.143720825, 2.001661745, 1.985588601, 1.218743389,
        1.776134996, 1.664076109, 1.482037358, 2.035519933, 1.972110447},
       StraightPath{}}};
  SolidOptions options;
  options.tolerance_mm = 0.4011845126;
  ASSERT_NO_FATAL_FAILURE(expect_sound(lattice_solid(segment, options)));
}

TEST(HorseshoeSolid, CannotBeDrawnWithoutSayingWhy) {
  Segment segment = columns(90, 180, true, 16, {1});
  std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm *= 1.02;
  EXPECT_THROW(lattice_solid(segment, {}), CannotDraw);
}

// Walls against the true arcs: at every radius a wall stands where its arc is, seen from the axis.
TEST(HorseshoeSolid, WallsStayWithinTheToleranceOfTheArcs) {
  for (const double thickness : {2.0, 10.0}) {
    for (const double tolerance : {0.1, 0.01, 0.002}) {
      SCOPED_TRACE(testing::Message() << thickness << " " << tolerance);
      Segment segment = columns(90, 150, true, 12, {1.5, 1.5});
      segment.lattice->thickness_mm = thickness;
      SolidOptions options;
      options.tolerance_mm = tolerance;
      const Solid solid = lattice_solid(segment, options);
      const double middle = segment.lattice_mid_radius_mm();
      const double radius = std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm;
      const double chord = 85.0 / 12;
      double worst = 0;
      int walls = 0;
      for (const Triangle& t : solid.mesh.triangles) {
        const bool floor = lies_between(solid.mesh, t, 0, 16 + tolerance);
        const bool ceiling = lies_between(solid.mesh, t, 16 + thickness - tolerance, 1e9);
        if (floor || ceiling) continue;
        for (const Point& p : points_over(solid.mesh, t, 4)) {
          if (p[2] < 2 || p[2] > 83) continue;
          ++walls;
          const double u = std::remainder(std::atan2(p[1], p[0]), std::numbers::pi) * middle;
          const int at = static_cast<int>(std::floor(p[2] / chord));
          double nearest = HUGE_VAL;
          for (int arc = at - 1; arc <= at + 1; ++arc) {
            // Axial columns bulge to the right, toward greater u, first.
            const double across = (arc % 2 == 0 ? u : -u) + radius * std::cos(radians(75));
            const double r = std::hypot(p[2] - (arc + 0.5) * chord, across);
            nearest = std::min(nearest, std::abs(std::abs(r - radius) - 0.75));
          }
          // In the plane at R_c; at radius r a length along u is r/R_c of it.
          const double scale = std::max(1.0, radius_of(p) / middle);
          worst = std::max(worst, scale * nearest);
        }
      }
      EXPECT_GT(walls, 1000);
      EXPECT_LE(worst, tolerance);
      std::printf("thickness %g, tolerance %g: walls within %.3g\n", thickness, tolerance, worst);
    }
  }
}

}  // namespace
}  // namespace latticast
