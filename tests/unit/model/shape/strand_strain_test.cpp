// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/strand_strain.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/pattern/horseshoe_path.h"
#include "model/horseshoe/horseshoe_law.h"
#include "model/strand/links.h"
#include "tests/unit/model/segments.h"

namespace latticast {
namespace {

using testing::columns;
using testing::degree;
using testing::paper_segment;

constexpr double start_z = 30;

Point at(double radius, double theta, double along) {
  return {radius * std::cos(theta), radius * std::sin(theta), start_z + along};
}

State twisted(double stretch, double twist, double inner_radius) {
  State state;
  state.stretch = stretch;
  state.twist_rad_per_mm = twist;
  state.inner_radius_mm = inner_radius;
  return state;
}

// docs/model.md#coordinates, written out.
double radius_then(double radius, const State& state) {
  const double a = state.inner_radius_mm;
  return std::sqrt(a * a + (radius * radius - 144) / state.stretch);
}

double strip_strain(double radius, double angle, const State& state) {
  const double r = radius_then(radius, state);
  const double around = r / radius * std::cos(angle) + state.twist_rad_per_mm * r * std::sin(angle);
  const double along = state.stretch * std::sin(angle);
  return std::sqrt(around * around + along * along) - 1;
}

Segment strips_alone(std::initializer_list<double> angles) {
  Segment segment = paper_segment(angles);
  segment.lattice->rings.reset();
  return segment;
}

TEST(StrandStrain, OfAnAffineMapIsTheStretchAlongEachStrand) {
  const State state = twisted(1.3, -0.01, 13.1);
  for (const double angle : {36.0, 90.0, 120.0, 2.0}) {
    SCOPED_TRACE(angle);
    const Segment segment = strips_alone({angle});
    TriangleMesh mesh;
    const double lead = angle == 90 ? 0 : 1 / std::tan(angle * degree) / 17;
    for (int i = 0; i < 40; ++i) {
      mesh.vertices.push_back(at(16 + 0.05 * i, i * pi / 4 + 2 * i * lead, 2 * i));
    }
    const std::vector<double> strains =
        strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
    ASSERT_EQ(strains.size(), 40U);
    for (int i = 0; i < 40; ++i) {
      EXPECT_NEAR(strains[i], strip_strain(16 + 0.05 * i, angle * degree, state), 1e-12) << i;
    }
  }
}

// Corners of the flat sectors of a mesh within 0.05 mm of the cylinders.
TEST(StrandStrain, OfCornersIsThatOfTheFacesTheyStandFor) {
  const State state = twisted(1.3, -0.01, 13.1);
  TriangleMesh mesh;
  mesh.vertices = {at(18.049, 0, 0), at(16.04, 0, 0), at(17.9, 0, 0)};
  const std::vector<double> strains =
      strand_strains(strand_field(strips_alone({36}), mesh, start_z, 0.05), state);
  EXPECT_NEAR(strains[0], strip_strain(18, 36 * degree, state), 1e-12);
  EXPECT_NEAR(strains[1], strip_strain(16, 36 * degree, state), 1e-12);
  EXPECT_NEAR(strains[2], strip_strain(17.9, 36 * degree, state), 1e-12);
}

TEST(StrandStrain, OfRingsIsTheChangeOfRadius) {
  const State state = twisted(1.3, 0, 11.4);
  const Segment segment = paper_segment({});
  TriangleMesh mesh;
  const double pitch = 83.0 / 7;
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back(at(17, 0.7 * i, i * pitch + 1.9));
  for (const double strain : strand_strains(strand_field(segment, mesh, start_z, 0.01), state)) {
    EXPECT_NEAR(strain, radius_then(17, state) / 17 - 1, 1e-12);
    EXPECT_LT(strain, 0);
  }
}

TEST(StrandStrain, WhereStrandsMeetIsThatOfLargestMagnitude) {
  const State state = twisted(1.25, -0.012, 12.4);
  const Segment segment = paper_segment({36, 144});
  const double ring = radius_then(17, state) / 17 - 1;
  const double one = strip_strain(17, 36 * degree, state);
  const double other = strip_strain(17, 144 * degree, state);
  ASSERT_GT(std::abs(other), std::abs(one));
  ASSERT_GT(std::abs(other), std::abs(ring));
  const double lead = 1 / std::tan(36 * degree) / 17;
  TriangleMesh mesh;
  mesh.vertices = {at(17, 0, 0), at(17, 6 * lead, 6), at(17, -6 * lead, 6)};
  const std::vector<double> strains =
      strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
  EXPECT_NEAR(strains[0], other, 1e-12);
  EXPECT_NEAR(strains[1], one, 1e-12);
  EXPECT_NEAR(strains[2], other, 1e-12);
}

// Strand 3 alone is wide enough to hold the place; the next ones are nearer to it.
TEST(StrandStrain, FindsAWideStrandBehindNarrowOnes) {
  Segment segment = strips_alone({90});
  segment.lattice->rings = Rings{2, std::nullopt, 2};
  segment.lattice->grids = {{90, {0.1, 0.1, 0.1, 60, 0.1, 0.1, 0.1, 0.1}, StraightPath{}}};
  TriangleMesh mesh;
  mesh.vertices = {at(17, 1.4 * pi / 4, 40), at(17, 5.6 * pi / 4, 40)};
  const StrandField field = strand_field(segment, mesh, start_z, 1e-6);
  ASSERT_EQ(field.members.size(), 2U);
  EXPECT_EQ(field.members[0].grid, 0);
  EXPECT_NEAR(field.members[0].theta_rad, 3 * pi / 4, 1e-12);
  EXPECT_NEAR(std::remainder(field.members[1].theta_rad - 3 * pi / 4, 2 * pi), 0, 1e-12);
}

TEST(StrandStrain, OfPlacesBesideAllStrandsIsThatOfTheNearest) {
  const State state = twisted(1.2, 0, 12);
  Segment segment = paper_segment({90});
  TriangleMesh mesh;
  // Half a millimetre above a ring, two beside a strand; and the other way round.
  mesh.vertices = {at(17, 3.0 / 17, 2.5), at(17, 1.5 / 17, 4.2)};
  const std::vector<double> strains =
      strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
  EXPECT_NEAR(strains[0], radius_then(17, state) / 17 - 1, 1e-12);
  EXPECT_NEAR(strains[1], 0.2, 1e-12);
}

TEST(StrandStrain, OfHorseshoesIsTheirMostStretchedFibres) {
  Segment segment = columns({1, 2, 1, 2, 1, 2});
  segment.lattice->rings.reset();
  for (const double stretch : {1.35, 0.9}) {
    const State state = twisted(stretch, 0, 12);
    TriangleMesh mesh;
    const double radius = 85.0 / 32;
    // Tops of arcs bulge by a radius; the first one to the right.
    for (int j = 0; j < 6; ++j) {
      mesh.vertices.push_back(at(17, j * pi / 3 + radius / 17, radius));
      mesh.vertices.push_back(at(17, j * pi / 3 - radius / 17, 3 * radius));
    }
    const std::vector<double> strains =
        strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
    for (int i = 0; i < 12; ++i) {
      const double width = i / 2 % 2 == 0 ? 1 : 2;
      const HorseshoeShape shape =
          std::get<HorseshoeShape>(*link_shape(segment, segment.lattice->grids[0], width));
      EXPECT_NEAR(strains[i], largest_fibre_strain(shape, stretch - 1).value(), 1e-12) << i;
    }
  }
}

// A bent segment's chords are strained by everything between both sides' values.
TEST(StrandStrain, OfBentHorseshoesIsInterpolatedWithinATenThousandth) {
  Segment segment = columns(std::vector<double>(24, 0.6));
  segment.lattice->rings.reset();
  std::get<Horseshoe>(segment.lattice->grids[0].path).radius_mm = 85.0 / 64;
  State state = twisted(1.1, 0, 12.2);
  state.bend_rad_per_mm = {0.012, 0.003};
  TriangleMesh mesh;
  for (int j = 0; j < 24; ++j) mesh.vertices.push_back(at(17, j * pi / 12, 0));
  const std::vector<double> strains =
      strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
  const HorseshoeShape shape =
      std::get<HorseshoeShape>(*link_shape(segment, segment.lattice->grids[0], 0.6));
  for (int j = 0; j < 24; ++j) {
    const double r = radius_then(17, state);
    const double chord = 0.1 + r * (0.012 * std::cos(j * pi / 12) + 0.003 * std::sin(j * pi / 12));
    EXPECT_NEAR(strains[j], largest_fibre_strain(shape, chord).value(), 1e-4) << j;
  }
}

TEST(StrandStrain, OfBendingTurnsWithTheFrame) {
  Segment segment = strips_alone({36});
  State state = twisted(1.1, 0.002, 12.2);
  const double lead = 1 / std::tan(36 * degree) / 17;
  state.bend_rad_per_mm = {0.01, 0};
  state.frame_turn_rad_per_mm = lead;
  TriangleMesh mesh;
  for (int i = 0; i < 10; ++i) mesh.vertices.push_back(at(16, 8 * i * lead, 8 * i));
  const std::vector<double> strains =
      strand_strains(strand_field(segment, mesh, start_z, 0.01), state);
  const double r = radius_then(16, state);
  const double around = r / 16 * std::cos(36 * degree) + 0.002 * r * std::sin(36 * degree);
  const double along = (1.1 + 0.01 * r) * std::sin(36 * degree);
  for (const double strain : strains) {
    EXPECT_NEAR(strain, std::hypot(around, along) - 1, 1e-12);
  }
}

TEST(StrandStrain, OfAMeshAtRestIsNone) {
  Segment segment = columns({1, 2, 1, 2});
  const State state = twisted(1, 0, 12);
  TriangleMesh mesh;
  for (int i = 0; i < 50; ++i) mesh.vertices.push_back(at(16 + 0.04 * i, 0.3 * i, 1.7 * i));
  for (const double strain : strand_strains(strand_field(segment, mesh, start_z, 0.01), state)) {
    EXPECT_NEAR(strain, 0, 1e-14);
  }
  EXPECT_TRUE(strand_strains(strand_field(segment, {}, 0, 0.01), state).empty());
}

TEST(LinerStrain, IsTheLargestPrincipalStretchOfTheMap) {
  const Segment segment = paper_segment({36});
  const State simple = twisted(1.4, 0, 12.5);
  TriangleMesh mesh;
  mesh.vertices = {at(12, 1, 5), at(16, 2, 80)};
  const std::vector<double> strains = liner_strains(segment, mesh, start_z, 0.01, simple);
  EXPECT_NEAR(strains[0], 0.4, 1e-12);
  EXPECT_NEAR(strains[1], 0.4, 1e-12);
  // The largest singular value of [hoop shear; 0 axial].
  const State state = twisted(1.2, 0.03, 15);
  const double r = radius_then(14, state);
  const double f[3] = {r / 14, 0.03 * r, 1.2};
  const double sum = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
  const double product = f[0] * f[2];
  const double largest = 0.5 * (std::sqrt(sum + 2 * product) + std::sqrt(sum - 2 * product));
  mesh.vertices = {at(14, 1, 5)};
  EXPECT_NEAR(liner_strains(segment, mesh, start_z, 0.01, state)[0], largest - 1, 1e-12);
}

}  // namespace
}  // namespace latticast
