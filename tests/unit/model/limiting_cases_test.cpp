// SPDX-License-Identifier: GPL-3.0-or-later
// Cases whose answer is known from elsewhere: inextensible strands, laws that become one another,
// symmetries, work.
#include <cmath>

#include <gtest/gtest.h>

#include "model/numerics/gauss.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

const std::vector<double> pressures = {10, 20, 30, 40, 50, 60};

void expect_same_states(const Response& a, const Response& b, double relative) {
  ASSERT_EQ(a.states.size(), b.states.size());
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    ASSERT_EQ(a.states[i].has_value(), b.states[i].has_value());
    if (!a.states[i]) continue;
    EXPECT_NEAR(a.states[i]->stretch, b.states[i]->stretch, relative);
    EXPECT_NEAR(a.states[i]->inner_radius_mm / b.states[i]->inner_radius_mm, 1, relative);
    EXPECT_NEAR(a.states[i]->twist_rad_per_mm * 18, b.states[i]->twist_rad_per_mm * 18, relative);
  }
}

TEST(LimitingCases, InextensibleHelixWithRigidRings) {
  Segment segment = paper_segment({36});
  segment.lattice->thickness_mm = 1e-3;
  segment.lattice->material.law = Linear{1e9, 0.5};
  const Response response = predict(segment, with_joint(JointModel::none), pressures);
  ASSERT_EQ(response.status, Status::ok) << response.message;
  const double c = std::cos(36 * degree);
  const double s = std::sin(36 * degree);
  for (const auto& state : response.states) {
    const double around = c + state->twist_rad_per_mm * segment.lattice_mid_radius_mm() * s;
    EXPECT_NEAR(around * around + std::pow(state->stretch * s, 2), 1, 1e-5);
    EXPECT_NEAR(state->outer_radius_mm, segment.outer_radius_mm(), 1e-4);
    EXPECT_LT(state->stretch, 1 / s);
  }
  EXPECT_GT(response.states.back()->stretch, 1.4);
}

/// Stretch of a thin soft bladder in a stiff braid of angles alpha and 180 - alpha, no rings.
double mckibben_stretch(double angle_deg) {
  Segment segment = tube(12, 12.0001, NeoHookean{1e-3});
  Lattice lattice;
  lattice.thickness_mm = 1e-4;
  lattice.material.law = Linear{1e6, 0.5};
  lattice.grids = {grid(angle_deg, 8, 2), grid(180 - angle_deg, 8, 2)};
  segment.lattice = lattice;
  const Response response =
      predict(segment, with_joint(JointModel::none), std::vector<double>{0.001});
  return response.states[0]->stretch;
}

TEST(LimitingCases, McKibbenNeutralAngle) {
  // Below arctan(1/sqrt 2) a braid lengthens under pressure, above it shortens.
  double low = 33;
  double high = 38;
  ASSERT_GT(mckibben_stretch(low), 1);
  ASSERT_LT(mckibben_stretch(high), 1);
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (mckibben_stretch(middle) > 1 ? low : high) = middle;
  }
  EXPECT_NEAR(low, std::atan(std::sqrt(0.5)) / degree, 2e-3);
}

TEST(LimitingCases, YeohWithoutHigherTermsIsNeoHookean) {
  Segment yeoh = paper_segment({36});
  yeoh.liner.material.law = Yeoh{0.04, 0, 0};
  expect_same_states(predict(yeoh, {}, pressures), predict(paper_segment({36}), {}, pressures),
                     1e-13);
}

TEST(LimitingCases, OgdenOfPowersTwoIsNeoHookeanAndMooney) {
  Segment ogden = paper_segment({36});
  ogden.liner.material.law = Ogden{{0.08}, {2}};
  expect_same_states(predict(ogden, {}, pressures), predict(paper_segment({36}), {}, pressures),
                     1e-10);
  Segment mooney = ogden;
  mooney.liner.material.law = Mooney{0.035, 0.005};
  ogden.liner.material.law = Ogden{{0.07, -0.01}, {2, -2}};
  expect_same_states(predict(ogden, {}, pressures), predict(mooney, {}, pressures), 1e-10);
}

TEST(LimitingCases, GentWithoutLimitIsNeoHookean) {
  Segment gent = paper_segment({36});
  gent.liner.material.law = Gent{0.08, 1e12};
  expect_same_states(predict(gent, {}, pressures), predict(paper_segment({36}), {}, pressures),
                     1e-10);
}

TEST(LimitingCases, GentLocksUpWithoutNonsense) {
  const Segment segment = tube(14, 18, Gent{0.08, 2});
  std::vector<double> rising;
  for (double p = 1; p < 2000; p *= 1.3) rising.push_back(p);
  const Response response = predict(segment, {}, rising);
  const Section section = prepare_section(segment, {});
  double before = 0;  // cavity growth, which a stable branch increases with pressure
  for (std::size_t i = 0; i < rising.size(); ++i) {
    if (!response.states[i]) continue;
    const Deformation q = response.states[i]->deformation(14);
    ASSERT_TRUE(std::isfinite(q.elongation) && std::isfinite(response.states[i]->residual));
    const double growth = cavity_growth(section, q).value;
    EXPECT_GT(growth, before);
    EXPECT_LT(stretch_limit_used(section, q), 1);
    before = growth;
  }
  EXPECT_GT(before, pi * 14 * 14);
  if (response.status != Status::ok) {
    EXPECT_NE(response.message.find("stretch limit (Gent)"), std::string::npos) << response.message;
  }
}

TEST(LimitingCases, SupplementaryFamiliesDoNotTwist) {
  Segment segment = paper_segment({36, 144, 70, 110});
  for (const JointModel joint : {JointModel::none, JointModel::paper, JointModel::clear_span}) {
    for (const auto& state : predict(segment, with_joint(joint), pressures).states) {
      EXPECT_LT(std::abs(state->twist_rad_per_mm), 1e-12);
    }
  }
  // In any order of the families, where sums do not cancel to the last bit.
  segment = paper_segment({36, 70, 144, 110});
  for (const auto& state : predict(segment, {}, pressures).states) {
    EXPECT_LT(std::abs(state->twist_rad_per_mm), 1e-12);
  }
}

TEST(LimitingCases, MirroredLatticeMirrorsTheTwist) {
  const Response right = predict(paper_segment({36, 60}), {}, pressures);
  const Response left = predict(paper_segment({144, 120}), {}, pressures);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    EXPECT_EQ(right.states[i]->stretch, left.states[i]->stretch);
    EXPECT_EQ(right.states[i]->twist_rad_per_mm, -left.states[i]->twist_rad_per_mm);
  }
}

TEST(LimitingCases, SplittingAFamilyChangesNothing) {
  Segment split = paper_segment({36, 36});
  split.lattice->grids = {grid(36, 3, 2), grid(36, 5, 2)};
  expect_same_states(predict(split, {}, pressures), predict(paper_segment({36}), {}, pressures),
                     1e-11);
}

TEST(LimitingCases, RingsOnlyAndGridsOnly) {
  const Response rings = predict(paper_segment({}), {}, std::vector<double>{40});
  ASSERT_EQ(rings.status, Status::ok) << rings.message;
  EXPECT_EQ(rings.states[0]->twist_rad_per_mm, 0);
  EXPECT_GT(rings.states[0]->stretch,
            predict(paper_segment({36}), {}, pressures).states[3]->stretch);
  Segment grids = paper_segment({36, 144});
  grids.lattice->rings.reset();
  EXPECT_TRUE(predict(grids, {}, pressures).states[0]);
  Segment empty_lattice = paper_segment({});
  empty_lattice.lattice->rings.reset();
  expect_same_states(predict(empty_lattice, {}, std::vector<double>{5}),
                     predict(tube(12, 16, NeoHookean{0.08}), {}, std::vector<double>{5}), 1e-12);
}

TEST(LimitingCases, MixtureOfNothingIsTheTube) {
  ModelChoice mixture;
  mixture.wall = WallKind::mixture;
  expect_same_states(predict(tube(12, 16, NeoHookean{0.08}), mixture, std::vector<double>{5}),
                     predict(tube(12, 16, NeoHookean{0.08}), {}, std::vector<double>{5}), 1e-13);
}

/// Stored energy at a state, under a quadrature of its own.
double energy_at(const Segment& segment, const ModelChoice& model, const State& state) {
  const Section section = prepare_section(segment, model);
  return stored_energy(section, make_quadrature(section, 40, 40),
                       state.deformation(segment.inner_radius_mm()))
      ->value;
}

TEST(LimitingCases, PressureWorkIsStoredEnergy) {
  const GaussRule rule = gauss_legendre(24);
  for (const double end_kpa : {60.0, -40.0}) {
    for (const Held held : {Held{}, Held{.twist = true}, Held{.stretch = true}}) {
      const Segment segment = paper_segment({36, 100});
      std::vector<double> path;
      for (const double x : rule.points) path.push_back(end_kpa * 0.5 * (1 + x));
      path.push_back(end_kpa);
      const Response response = predict(segment, {}, path, held);
      ASSERT_EQ(response.status, Status::ok) << response.message;
      const auto growth = [&](const State& state) {
        return pi * (std::pow(state.inner_radius_mm, 2) * state.stretch - 144);
      };
      // Integral of P dV, by parts.
      double work = end_kpa / 1000 * growth(*response.states.back());
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        work -= rule.weights[i] * 0.5 * end_kpa / 1000 * growth(*response.states[i]);
      }
      const double energy = energy_at(segment, {}, *response.states.back());
      EXPECT_NEAR(work, energy, 1e-9 * energy);
    }
  }
}

TEST(LimitingCases, ReactionsAreSlopesOfTheHeldEnergy) {
  // The torque that holds k = 0 is what a free section would have to be given: at a pressure where
  // the free section twists left, holding takes a right-handed torque.
  const State held = *predict(paper_segment({36}), {}, pressures, {.twist = true}).states[2];
  const State free = *predict(paper_segment({36}), {}, pressures).states[2];
  EXPECT_LT(free.twist_rad_per_mm, 0);
  EXPECT_GT(held.torque_nmm, 0);
  EXPECT_EQ(free.torque_nmm, 0);
  // Blocked force of a rigidly ringed bare liner: the cap force, less what the liner's own pressed
  // wall carries; it pushes outwards, so holding takes compression.
  const State blocked = *predict(paper_segment({36}), {}, pressures, {.stretch = true}).states[2];
  EXPECT_EQ(blocked.stretch, 1);
  EXPECT_LT(blocked.force_n, 0);
}

}  // namespace
}  // namespace latticast::testing
