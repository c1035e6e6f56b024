// SPDX-License-Identifier: GPL-3.0-or-later
// Designs at the ends of what can be asked for: every answer is put to the second opinion of
// bench/atlas_check.h, and designs that were answered wrongly once are kept.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "bench/atlas_check.h"
#include "bench/atlas_designs.h"
#include "bench/plain_path.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

void expect_none_wrong(const AtlasDesign& design, const std::string& name) {
  const std::vector<Judgement> findings = examine(design);
  ASSERT_EQ(findings.size(), design.pressures_kpa.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    EXPECT_NE(findings[i].verdict, Verdict::wrong)
        << name << ", " << design.pressures_kpa[i] << " kPa: " << findings[i].kind << ", "
        << findings[i].detail << "\n"
        << description(design);
  }
}

Lattice layer(double thickness_mm, double modulus_mpa) {
  Lattice lattice;
  lattice.thickness_mm = thickness_mm;
  lattice.material.law = Linear{modulus_mpa, 0.5};
  return lattice;
}

TEST(ExtremeCases, RandomSampleOfTheAtlas) {
  const unsigned seed = 7;
  std::printf("seed %u\n", seed);
  for (int i = 0; i < 60; ++i) {
    expect_none_wrong(random_atlas_design(seed, i), "design " + std::to_string(i));
  }
}

TEST(ExtremeCases, Maps) {
  for (const AtlasMap& map : atlas_maps(3)) {
    for (std::size_t i = 0; i < map.designs.size(); ++i) {
      expect_none_wrong(map.designs[i], map.name + " " + std::to_string(i));
    }
  }
}

/// Stiff rings and strands lock at a stretch of 1/sin(alpha). Close to it, another branch has its
/// least pressure, which is not where this one ends.
TEST(ExtremeCases, LockedStrandsGoOnBeyondTheLockingPressure) {
  AtlasDesign design;
  design.segment =
      tube(0.20754930324000148, 0.21273223432562686, Yeoh{0.35709, -0.00366066, 0.0133879});
  design.segment.length_mm = 25.3;
  design.segment.lattice = layer(0.0279, 9.45e6);
  design.segment.lattice->rings = Rings{15, std::nullopt, 1.03};
  design.segment.lattice->grids = {grid(72.746418203925543, 23, 9.93e-5)};
  design.model.joint = JointModel::none;
  design.pressures_kpa = {72000, 80000, 181000, 448000};
  const Response response = predict(design.segment, design.model, design.pressures_kpa);
  EXPECT_EQ(response.status, Status::ok) << response.message;
  EXPECT_TRUE(response.critical_points.empty());
  expect_none_wrong(design, "locked");
}

/// A thick wall whose bore closes: r(R) all but vanishes at the bore, and the closing pressure of a
/// neo-Hookean tube of held length is known, P/mu = ln(R_o r_i/(R_i r_o)) + (r_i^2 - R_i^2)/2 *
/// (1/r_i^2 - 1/r_o^2) at stretch 1 and no twist (docs/model.md#closed-forms-of-a-bare-tube).
TEST(ExtremeCases, ThickWallsCloseAtTheExactPressure) {
  for (const double ratio : {0.05, 0.1, 0.3, 0.6, 0.9}) {
    const double mu = 0.08;
    const double outer = 20;
    const double inner = outer * ratio;
    const Segment segment = tube(inner, outer, NeoHookean{mu});
    const double bore = 1e-3 * inner;
    const double outside = std::sqrt(bore * bore + outer * outer - inner * inner);
    const double exact_kpa =
        1000 * mu *
        (std::log(outer * bore / (inner * outside)) +
         0.5 * (bore - inner) * (bore + inner) * (1 / (bore * bore) - 1 / (outside * outside)));
    const Response response =
        predict(segment, {}, std::vector<double>{10 * exact_kpa}, {.twist = true, .stretch = true});
    ASSERT_EQ(response.critical_points.size(), 1U) << response.message;
    const CriticalPoint& end = response.critical_points.front();
    EXPECT_EQ(end.kind, CriticalKind::closure);
    EXPECT_NEAR(end.pressure_kpa / exact_kpa, 1, 1e-9) << "R_i/R_o = " << ratio;
  }
}

/// A linear wall pulled inside out by suction is no state.
TEST(ExtremeCases, RodsNameAWallWithoutLength) {
  Segment segment = tube(12, 16, NeoHookean{0.08});
  segment.lattice = layer(2, 1e-3);
  segment.lattice->grids = {grid(90, 8, 1)};
  ModelChoice rods;
  rods.columns = ColumnModel::rods;
  const Response response = predict(segment, rods, std::vector<double>{-20, -1000});
  EXPECT_TRUE(response.states[0].has_value());
  EXPECT_FALSE(response.states[1].has_value());
  EXPECT_NE(response.message.find("no length"), std::string::npos) << response.message;
}

/// The unbent section counts each strand by its own law too.
TEST(ExtremeCases, UnequalHorseshoesAreCountedByTheirOwnLaws) {
  const Section section = prepare_section(columns(halves(8, 2, 0.5)), {});
  const Quadrature quadrature = make_quadrature(section, 6, 4, 12);
  const Deformation at{0.1, 0, 0.5};
  const auto unbent = stored_energy(section, quadrature, at, std::array{0, 1, 2});
  const auto bendable = stored_energy(section, quadrature, at);
  ASSERT_TRUE(unbent && bendable);
  for (const int i : {0, 1, 2}) {
    EXPECT_NEAR(unbent->gradient[i], bendable->gradient[i],
                1e-12 * std::abs(bendable->gradient[i]) + 1e-12);
  }
}

/// Hundreds of equal strands are as good as a continuous layer.
TEST(ExtremeCases, ManyStrandsNeedNoMoreTimeOrDigits) {
  Segment segment = columns(halves(8, 1, 0.5));
  const double width = 1e-3;
  segment.lattice->grids.push_back(grid(90, 127, width));
  const Response counted = predict(segment, {}, std::vector<double>{20});
  segment.lattice->grids.back() = grid(90, 1270, width / 10);
  const Response averaged = predict(segment, {}, std::vector<double>{20});
  ASSERT_TRUE(counted.states[0] && averaged.states[0]);
  const PlainPath path(prepare_section(segment, {}), {});
  const ScaledState a = path.scaled(*counted.states[0]);
  const ScaledState b = path.scaled(*averaged.states[0]);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9);
}

/// The end of a horseshoe's law and a Gent rubber's limit are named where they are met.
TEST(ExtremeCases, LawsThatEndAreNamedInFewSteps) {
  const Response horseshoe = predict(columns(halves(16, 4, 2)), {}, std::vector<double>{1000});
  EXPECT_EQ(horseshoe.status, Status::not_converged);
  EXPECT_NE(horseshoe.message.find("law ends at"), std::string::npos) << horseshoe.message;

  AtlasDesign gent;
  gent.segment = tube(17, 94, Gent{0.01, 10.9});
  gent.segment.lattice = layer(93, 0.05);
  gent.segment.lattice->grids = {grid(49.5, 13, 0.18), grid(116, 1, 43)};
  gent.pressures_kpa = {1e5};
  const PreparedSegment prepared = prepare_segment(gent.segment, gent.model);
  SolverOptions few;
  few.most_steps = 200;
  const Response stretched = predict(prepared, gent.pressures_kpa, {}, few);
  EXPECT_NE(stretched.message.find("stretch limit"), std::string::npos) << stretched.message;
}

/// Asked for at once, a far pressure must meet the same end as many near ones: a wide tube's branch
/// passes close by another one.
TEST(ExtremeCases, FarRequestsMeetTheFirstEnd) {
  AtlasDesign design;
  design.segment = tube(3.0372742732772959, 3.0435057613748395, NeoHookean{1});
  design.segment.length_mm = 0.36726081381790343;
  design.segment.lattice = layer(0.043264342665213923, 2.5943e6);
  design.segment.lattice->rings = Rings{7, std::nullopt, 0.0021757722566343959};
  design.segment.lattice->grids = {grid(179.88644572598727, 3, 0.00056651077243027165),
                                   grid(138.31590675347712, 23, 0.0095667529315808693)};
  design.held.stretch = true;
  design.pressures_kpa = {6.48686e7};
  expect_none_wrong(design, "stretch held");
  const Response far = predict(design.segment, design.model, design.pressures_kpa, design.held);
  const std::vector<double> many = {1e6, 2e6, 2.5e6, 2.8e6, 2.9e6, 2.94e6, 3e6};
  const Response near = predict(design.segment, design.model, many, design.held);
  ASSERT_EQ(far.critical_points.size(), 1U);
  ASSERT_EQ(near.critical_points.size(), 1U);
  EXPECT_EQ(far.critical_points[0].kind, CriticalKind::limit_point);
  EXPECT_NEAR(far.critical_points[0].pressure_kpa, near.critical_points[0].pressure_kpa, 1e-3);
}

/// A tube that grows on and on while its pressure still rises has no bound that could be named.
TEST(ExtremeCases, GrowthWithoutABoundIsNoAsymptote) {
  AtlasDesign design;
  design.segment = tube(11.767445776899084, 12.945239872703606, NeoHookean{1});
  design.segment.length_mm = 4.5213869835606317;
  design.segment.lattice = layer(0.069941075702162472, 5.78027e6);
  design.segment.lattice->rings = Rings{3, std::nullopt, 0.21806948742567003};
  design.segment.lattice->grids = {grid(179.97045520748276, 8, 8.4202792710171055e-05)};
  design.held.bend = true;
  design.pressures_kpa = {165501.06481463448, 1e8};
  expect_none_wrong(design, "bending held");
}

}  // namespace
}  // namespace latticast::testing
