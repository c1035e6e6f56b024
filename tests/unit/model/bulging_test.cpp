// SPDX-License-Identifier: GPL-3.0-or-later
// Bulging of the liner: closed forms of strips and caps, limits of the gap, the units, and the
// finite-element cell of docs/bulging.md#against-a-finite-element-cell.
#include "model/bulging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "model/shape/inflated_wall.h"
#include "tests/golden/finite_element_cell.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// A strip at rest.
WallPatch strip(double span_mm, double thickness_mm, double shear_modulus_mpa) {
  WallPatch patch;
  patch.law = NeoHookean{shear_modulus_mpa};
  patch.span_mm = span_mm;
  patch.thickness_mm = thickness_mm;
  return patch;
}

double compliance(const WallPatch& patch) {
  const double height = 1e-6 * patch.span_mm;
  return height / cap_pressure_mpa(patch, height);
}

TEST(CapPressure, OfATensionedMembraneIsEightTensionsOverTheSpanSquared) {
  WallPatch patch = strip(20, 0.5, 1e-9);
  patch.tension_n_per_mm = 0.7;
  EXPECT_NEAR(compliance(patch), 20.0 * 20 / (8 * 0.7), 1e-4);
}

TEST(CapPressure, OfALongThinStripIsThatOfAClampedPlate) {
  // E = 3 mu, nu = 1/2: D = E t^3/(12 (1 - nu^2)) = mu t^3/3.
  const double stiffness = 0.08 * 1 / 3;
  EXPECT_NEAR(compliance(strip(1000, 1, 0.08)) / (1e12 / (384 * stiffness)), 1, 1e-3);
}

TEST(CapPressure, OfAShortThickStripIsShear) {
  EXPECT_NEAR(compliance(strip(0.1, 10, 0.08)) / (0.01 / (8 * (5.0 / 6) * 0.08 * 10)), 1, 1e-3);
}

// D w'''' - T w'' = q between clamps has the height q b^2/(8 T) (1 - tanh(u/2) 2/u) in the middle,
// u^2 = T b^2/(4 D); tension and plate side by side are an approximation to it.
TEST(CapPressure, OfAPlateUnderTensionIsNearTheExactOne) {
  for (const double u : {0.01, 0.3, 1.0, 2.0, 4.0, 8.0, 30.0, 300.0}) {
    WallPatch patch = strip(1000, 1, 0.08);
    const double stiffness = 0.08 / 3;
    patch.tension_n_per_mm = u * u * 4 * stiffness / 1e6;
    const double exact = 1e6 / (8 * patch.tension_n_per_mm) * (1 - std::tanh(u / 2) * 2 / u);
    EXPECT_GT(compliance(patch) / exact, 0.999) << u;
    EXPECT_LT(compliance(patch) / exact, 1.13) << u;
  }
}

TEST(CapPressure, OfAHalfCylinderIsLaplaces) {
  // At a semicircle the strip is pi/2 times as long and its radius is half of the span.
  const double stretch = pi / 2;
  const double tension = 0.08 * 0.01 * (stretch - std::pow(stretch, -3));
  EXPECT_NEAR(cap_pressure_mpa(strip(30, 0.01, 0.08), 15) / (tension / 15), 1, 1e-5);
}

TEST(CapPressure, FollowsTheLaw) {
  // The same shear modulus at rest; Gent and Yeoh stiffen, and Gent ends.
  WallPatch patch = strip(30, 0.01, 0.08);
  const double neo_hookean = cap_pressure_mpa(patch, 15);
  patch.law = Yeoh{0.04, 0.004, 0};
  const double stretch = pi / 2;
  const double j = stretch * stretch + 1 / (stretch * stretch) - 2;
  EXPECT_NEAR(cap_pressure_mpa(patch, 15) / neo_hookean, 1 + 2 * 0.004 / 0.04 * j, 1e-5);
  patch.law = Gent{0.08, 4};
  EXPECT_NEAR(cap_pressure_mpa(patch, 15) / neo_hookean, 1 / (1 - j / 4), 1e-5);
  EXPECT_EQ(cap_pressure_mpa(patch, 60), HUGE_VAL);
  // Held along the gap, I1 and I2 are the same.
  patch.law = Mooney{0.03, 0.01};
  EXPECT_NEAR(cap_pressure_mpa(patch, 15) / neo_hookean, 1, 1e-12);
  patch.law = Ogden{{0.06, -0.02}, {2, -2}};
  EXPECT_NEAR(cap_pressure_mpa(patch, 15) / neo_hookean, 1, 1e-12);
  patch.law = Linear{0.24, 0.499};
  EXPECT_DOUBLE_EQ(cap_pressure_mpa(patch, 15), neo_hookean);
}

TEST(CapPressure, RisesWithThicknessAndTensionAndFallsWithTheSpan) {
  constexpr unsigned seed = 20240117;
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    WallPatch patch = strip(random.log_between(1, 100), random.log_between(0.2, 10), 0.08);
    patch.stretch_squared = random.between(1, 4);
    patch.across_wall = random.between(0.4, 1);
    patch.invariant_minus_3 = random.between(0, 3);
    patch.tension_n_per_mm = random.log_between(0.001, 1);
    const double height = random.between(0.01, 0.2) * patch.span_mm;
    const double pressure = cap_pressure_mpa(patch, height);
    WallPatch other = patch;
    other.thickness_mm *= 1.1;
    EXPECT_GT(cap_pressure_mpa(other, height), pressure) << "seed " << seed << ", " << i;
    other = patch;
    other.tension_n_per_mm *= 1.1;
    EXPECT_GT(cap_pressure_mpa(other, height), pressure) << "seed " << seed << ", " << i;
    other = patch;
    other.span_mm *= 1.1;
    EXPECT_LT(cap_pressure_mpa(other, height), pressure) << "seed " << seed << ", " << i;
  }
}

/// The paper's tube with rings at a pitch, long enough for two of them.
Segment ringed(double pitch_mm, double width_mm = 2) {
  Segment segment = paper_segment({});
  segment.lattice->rings = Rings{std::nullopt, pitch_mm, width_mm};
  segment.length_mm = 4 * pitch_mm;
  return segment;
}

std::vector<Bulge> bulges_at(const Segment& segment, double pressure_kpa,
                             JointModel joint = JointModel::clear_span) {
  const PreparedSegment prepared = prepare_segment(segment, with_joint(joint));
  const Response response = predict(prepared, std::array{pressure_kpa});
  EXPECT_TRUE(response.states[0]) << response.message;
  return response.states[0] ? liner_bulges(segment, prepared, *response.states[0])
                            : std::vector<Bulge>{};
}

TEST(LinerBulges, VanishWithTheGap) {
  double before = HUGE_VAL;
  for (const double gap : {8.0, 2.0, 0.5, 0.1, 0.02}) {
    const Bulge bulge = bulges_at(ringed(2 + gap), 10).at(0);
    EXPECT_EQ(bulge.members, "rings");
    EXPECT_LT(bulge.height_mm / bulge.gap_mm, before);
    before = bulge.height_mm / bulge.gap_mm;
  }
  EXPECT_LT(before, 5e-3);
  EXPECT_GT(before, 0);
}

// Wide rings that are far apart hold the segment as a whole, but the wall between them is a bare
// tube, and balloons at that one's limit point.
TEST(LinerBulges, BalloonAsABareTubeBetweenFarRings) {
  for (const Law& law : {Law(NeoHookean{0.08}), Law(Yeoh{0.04, -0.0005, 0.00001})}) {
    const Response bare = predict(tube(12, 16, law), {}, std::array{200.0});
    ASSERT_FALSE(bare.critical_points.empty());
    const double limit = bare.critical_points[0].pressure_kpa;
    Segment segment = ringed(2e6, 1e6);
    segment.liner.material.law = law;
    EXPECT_FALSE(bulges_at(segment, 0.999 * limit).at(0).balloons());
    const Bulge beyond = bulges_at(segment, 1.001 * limit).at(0);
    EXPECT_TRUE(beyond.balloons());
    EXPECT_EQ(beyond.height_mm, HUGE_VAL);
  }
}

/// Height in mid gap of a thin tube between rigid rings at a small pressure: its wall bends, shears
/// and resists widening, clamped at the edges of the gap,
///     D psi'' + S (w' - psi) = 0,  S (w'' - psi') - K w + q = 0,
/// solved by its exponentials. Closed ends bear a quarter of the pressure: q = 3/4 P, K = E t/R^2.
double clamped_tube_bulge_mm(double shear_modulus_mpa, double radius_mm, double thickness_mm,
                             double gap_mm, double pressure_mpa) {
  using Complex = std::complex<double>;
  const double bending = shear_modulus_mpa * std::pow(thickness_mm, 3) / 3;
  const double shear = 5.0 / 6 * shear_modulus_mpa * thickness_mm;
  const double widening = 3 * shear_modulus_mpa * thickness_mm / (radius_mm * radius_mm);
  const double free_height = 0.75 * pressure_mpa / widening;
  const double half = 0.5 * widening / shear;
  const Complex spread = std::sqrt(Complex(half * half - widening / bending));
  const Complex a = std::sqrt(half + spread);
  const Complex b = std::sqrt(half - spread);
  const auto turning = [&](const Complex& rate) {
    return (rate - widening / (shear * rate)) * std::sinh(rate * 0.5 * gap_mm);
  };
  const Complex height_a = std::cosh(a * 0.5 * gap_mm);
  const Complex height_b = std::cosh(b * 0.5 * gap_mm);
  const Complex share = free_height / (height_a * turning(b) - height_b * turning(a));
  return free_height - (share * (turning(b) - turning(a))).real();
}

TEST(LinerBulges, AreNearThoseOfAClampedThinTube) {
  double least = HUGE_VAL;
  double most = 0;
  for (const double gap : {0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 64.0, 128.0}) {
    Segment segment = ringed(gap + 2);
    segment.liner.inner_radius_mm = 19.5;
    segment.liner.thickness_mm = 1;
    segment.lattice->material.law = Linear{1e6, 0.5};
    const double pressure = 1e-4 * 0.08;
    const double found = bulges_at(segment, 1000 * pressure).at(0).height_mm;
    const double ratio = found / clamped_tube_bulge_mm(0.08, 20, 1, gap, pressure);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  EXPECT_GT(least, 0.97);
  EXPECT_LT(most, 1.25);  // wide gaps are flat, no parabola: 1/0.8
}

TEST(LinerBulges, KnowNoUnitOfLength) {
  Segment small = paper_segment({36});
  Segment large = small;
  large.length_mm *= 3;
  large.liner.inner_radius_mm *= 3;
  large.liner.thickness_mm *= 3;
  large.lattice->thickness_mm *= 3;
  large.lattice->rings->width_mm *= 3;
  for (double& width : large.lattice->grids[0].widths_mm) width *= 3;
  const auto few = bulges_at(small, 40);
  const auto many = bulges_at(large, 40);
  ASSERT_EQ(few.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(few[i].height_mm, 0);
    EXPECT_NEAR(many[i].height_mm / few[i].height_mm, 3, 1e-6);
    EXPECT_NEAR(many[i].load_mpa / few[i].load_mpa, 1, 1e-8);
    EXPECT_NEAR(many[i].largest_load_mpa / few[i].largest_load_mpa, 1, 1e-6);
  }
}

TEST(LinerBulges, GrowWithPressureGapAndSoftness) {
  Segment segment = paper_segment({36});
  const double usual = bulges_at(segment, 30).at(0).height_mm;
  EXPECT_GT(bulges_at(segment, 33).at(0).height_mm, usual);
  Segment softer = segment;
  softer.liner.material.law = NeoHookean{0.07};
  EXPECT_GT(bulges_at(softer, 30).at(0).height_mm, usual);
  Segment fewer = segment;
  fewer.lattice->rings->count = 7;
  EXPECT_GT(bulges_at(fewer, 30).at(0).height_mm, usual);
  Segment thinner = segment;
  thinner.liner.inner_radius_mm = 12.5;
  thinner.liner.thickness_mm = 3.5;
  EXPECT_GT(bulges_at(thinner, 30).at(0).height_mm, usual);
}

TEST(LinerBulges, NoneUnderSuctionBetweenAxialStrandsOrWithoutALattice) {
  for (const Bulge& bulge : bulges_at(paper_segment({36}), -5)) EXPECT_EQ(bulge.height_mm, 0);
  Segment axial = paper_segment({90});
  axial.lattice->rings.reset();
  const auto between = bulges_at(axial, 1);
  ASSERT_EQ(between.size(), 1U);
  EXPECT_NEAR(between[0].load_mpa, 0, 1e-12);
  EXPECT_NEAR(between[0].height_mm, 0, 1e-6);
  EXPECT_TRUE(bulges_at(tube(12, 16, NeoHookean{0.08}), 5).empty());
}

TEST(LinerBulges, LieOnTheLengthenedSide) {
  // Columns that bend the tube: the gap between rings is wider than the mean stretch makes it.
  const Segment segment = columns(halves(16, 4, 2));
  const PreparedSegment prepared = prepare_segment(segment, {});
  const Response response = predict(prepared, std::array{40.0});
  const State& state = *response.states[0];
  const Bulge bulge = liner_bulges(segment, prepared, state).at(0);
  const double pitch = 83.0 / 7;
  EXPECT_GT(bulge.gap_mm, 1.05 * state.stretch * pitch - 2);
  EXPECT_GT(bulge.height_mm, 0);
}

TEST(LinerBulges, OfEffectiveRodsAreLeftToTheRings) {
  Segment segment = columns(halves(16, 4, 2));
  segment.liner.material.law = Linear{0.082, 0.499};
  ModelChoice rods;
  rods.columns = ColumnModel::rods;
  const PreparedSegment prepared = prepare_segment(segment, rods);
  const Response response = predict(prepared, std::array{40.0});
  const auto bulges = liner_bulges(segment, prepared, *response.states[0]);
  ASSERT_EQ(bulges.size(), 1U);
  EXPECT_GT(bulges[0].load_mpa, 0.03);
  EXPECT_GT(bulges[0].height_mm, 0);
}

// What docs/bulging.md states: predicted states and their bulges, nothing of the cell entering.
TEST(LinerBulges, AreNearThoseOfAFiniteElementCell) {
  const std::vector<CellState> cell = finite_element_cell();
  ASSERT_EQ(cell.size(), 6U);
  Segment segment = paper_segment({36});
  segment.length_mm = 80;
  segment.lattice->rings = Rings{std::nullopt, 10.0, 2};
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const CellState& at : cell) {
    const double pressure_kpa = at.pressure_kpa;
    const double bulge_mm = at.void_growth_mm - at.ring_growth_mm;
    double sum = 0;
    for (const Bulge& bulge : bulges_at(segment, pressure_kpa)) sum += bulge.height_mm;
    const double percent = 100 * (sum / bulge_mm - 1);
    SCOPED_TRACE(percent);
    least = std::min(least, percent);
    most = std::max(most, percent);
  }
  EXPECT_NEAR(least, 3.1, 0.1);
  EXPECT_NEAR(most, 23.1, 0.1);
}

}  // namespace
}  // namespace latticast::testing
