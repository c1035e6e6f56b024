// SPDX-License-Identifier: GPL-3.0-or-later
// The stored energy against a separate, literal evaluation of its definition in extended precision.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "tests/unit/design/material/literal_laws.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

struct Tensor {
  std::array<Vector, 3> row{};
};

Vector apply(const Tensor& f, const Vector& a) {
  Vector b{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) b[i] += f.row[i][j] * a[j];
  }
  return b;
}

Real dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// F of docs/model.md#coordinates at reference radius R, for q = (lambda, k, a).
Tensor deformation_gradient(const Vector& q, Real inner, Real radius) {
  const Real r = std::sqrt(q[2] * q[2] + (radius * radius - inner * inner) / q[0]);
  return {{Vector{radius / (r * q[0]), 0, 0}, Vector{0, r / radius, q[1] * r}, Vector{0, 0, q[0]}}};
}

/// Principal stretches by the eigenvalues of F F^T in the plane of the wall.
Real rubber(const Law& law, const Tensor& f) {
  const Real around = dot(f.row[1], f.row[1]);
  const Real along = dot(f.row[2], f.row[2]);
  const Real mean = (around + along) / 2;
  const Real larger = std::sqrt(mean + std::hypot((around - along) / 2, dot(f.row[1], f.row[2])));
  const Real across = f.row[0][0];
  return literal_energy(law, {larger, 1 / (larger * across), across});
}

/// Paper (3) and (4) for one strand family; theta_t by the paper's arccos.
Real strand(const Tensor& f, Real angle, Real modulus, Real joint) {
  const Vector a{0, std::cos(angle), std::sin(angle)};
  const Vector b = apply(f, a);
  const Real s = std::sqrt(dot(b, b));
  const Real theta = std::acos(std::min<Real>(1, dot(a, b) / s));
  return modulus / 2 * (s - 1) * (s - 1) + joint / 2 * theta * theta;
}

/// Composite Simpson rule, 2000 intervals.
Real integrate(Real from, Real to, const std::function<Real(Real)>& density) {
  const int intervals = 2000;
  const Real h = (to - from) / intervals;
  Real sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const Real r = from + i * h;
    const int weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * density(r) * 2 * static_cast<Real>(pi) * r;
  }
  return sum * h / 3;
}

/// docs/model.md#energy written out for the segment of paper_segment with the given law and joint.
Real literal_energy(const Segment& segment, const ModelChoice& model, const Vector& q) {
  const bool layered = model.wall == WallKind::layered;
  const Real inner = segment.inner_radius_mm();
  const Real middle = segment.liner_outer_radius_mm();
  const Real outer = segment.outer_radius_mm();
  const Real modulus = 19.46L;
  const Real pitch = 83.0L / 7;
  const Real rings = layered ? 16.0L / 85 : 0.09L;
  const auto density = [&](Real radius) {
    const Tensor f = deformation_gradient(q, inner, radius);
    const Real ring = f.row[1][1] - 1;
    Real w = rings * modulus / 2 * ring * ring;
    for (const Grid& family : segment.lattice->grids) {
      const Real angle = family.angle_deg * (static_cast<Real>(pi) / 180);
      const Real width = family.widths_mm[0];
      const Real fraction =
          layered ? family.count() * width / (2 * static_cast<Real>(pi) * 17 * std::sin(angle))
                  : 0.09L;
      const Real length = pitch / std::sin(angle);
      // 12 E I / L_t over V, I = h w^3 / 12, V = w h L_t, h = 2.
      Real joint = 12 * modulus * (2 * width * width * width / 12) / length / (width * 2 * length);
      if (model.joint == JointModel::none) joint = 0;
      if (model.joint == JointModel::clear_span) {
        joint *= std::pow(length / ((pitch - 2) / std::sin(angle)), 3.0L);
      }
      w += strand(f, angle, fraction * modulus, fraction * joint);
    }
    return w;
  };
  const auto liner = [&](Real radius) {
    return (layered ? 1 : 0.91L) *
           rubber(segment.liner.material.law, deformation_gradient(q, inner, radius));
  };
  return integrate(inner, layered ? middle : outer, liner) +
         integrate(layered ? middle : inner, outer, density);
}

struct Case {
  Law law;
  JointModel joint;
  WallKind wall;
};

const std::vector<Case> cases = {
    {NeoHookean{0.08}, JointModel::none, WallKind::layered},
    {NeoHookean{0.08}, JointModel::paper, WallKind::layered},
    {NeoHookean{0.08}, JointModel::clear_span, WallKind::layered},
    {Yeoh{0.04, -0.002, 0.0003}, JointModel::paper, WallKind::layered},
    {Gent{0.08, 12}, JointModel::clear_span, WallKind::layered},
    {NeoHookean{0.08}, JointModel::paper, WallKind::mixture},
    {Mooney{0.03, 0.01}, JointModel::paper, WallKind::layered},
    {Ogden{{0.04, 0.002}, {1.3, 5}}, JointModel::clear_span, WallKind::layered},
    {Ogden{{0.04, -0.01}, {1.3, -2}}, JointModel::none, WallKind::mixture},
    {Gent{0.08, 12}, JointModel::none, WallKind::mixture},
};

struct Prepared {
  Segment segment;
  ModelChoice model;
  Section section;
  Quadrature quadrature;
};

Prepared prepare(const Case& example) {
  Prepared p;
  p.segment = paper_segment({36, 120});
  p.segment.liner.material.law = example.law;
  p.model.joint = example.joint;
  p.model.wall = example.wall;
  p.section = prepare_section(p.segment, p.model);
  p.quadrature = make_quadrature(p.section, 24, 24);
  return p;
}

Deformation random_deformation(Random& random) {
  return {random.between(-0.2, 0.6), random.between(-0.04, 0.04), random.between(-2, 5)};
}

SectionEnergy energy(const Prepared& p, const Deformation& q) {
  return stored_energy(p.section, p.quadrature, q).value();
}

TEST(Section, EnergyIsTheIntegralOfItsDefinition) {
  std::printf("seed 11\n");
  Random random(11);
  for (const Case& example : cases) {
    const Prepared p = prepare(example);
    for (int i = 0; i < 3; ++i) {
      const Deformation q = random_deformation(random);
      const Real expected = literal_energy(
          p.segment, p.model,
          {1 + static_cast<Real>(q.elongation), q.twist, 12 + static_cast<Real>(q.inner_growth)});
      EXPECT_NEAR(energy(p, q).value / static_cast<double>(expected), 1, 1e-11);
    }
  }
}

/// Central differences of 6th order.
template <class F>
auto slope(const F& f, double h) {
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

Deformation shifted(Deformation q, int coordinate, double by) {
  (coordinate == 0 ? q.elongation : coordinate == 1 ? q.twist : q.inner_growth) += by;
  return q;
}

constexpr std::array<double, 3> difference_step = {2e-3, 1e-4, 2e-2};

TEST(Section, GradientIsTheSlopeOfTheLiteralEnergy) {
  std::printf("seed 12\n");
  Random random(12);
  for (const Case& example : cases) {
    const Prepared p = prepare(example);
    const Deformation q = random_deformation(random);
    const SectionEnergy exact = energy(p, q);
    for (int i = 0; i < 3; ++i) {
      const auto along = [&](double h) {
        Vector at{1 + static_cast<Real>(q.elongation), q.twist,
                  12 + static_cast<Real>(q.inner_growth)};
        at[i] += h;
        return literal_energy(p.segment, p.model, at);
      };
      const double scale = exact.value / std::abs(difference_step[i]) * 1e-2;
      const auto expected = static_cast<double>(slope(along, difference_step[i]));
      EXPECT_NEAR(exact.gradient[i], expected, 1e-9 * scale) << "coordinate " << i;
    }
  }
}

TEST(Section, HessianIsTheSlopeOfTheGradient) {
  std::printf("seed 13\n");
  Random random(13);
  for (const Case& example : cases) {
    const Prepared p = prepare(example);
    for (int trial = 0; trial < 5; ++trial) {
      const Deformation q = trial == 0 ? Deformation{} : random_deformation(random);
      const SectionEnergy exact = energy(p, q);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const auto along = [&](double h) { return energy(p, shifted(q, i, h)).gradient[j]; };
          const double scale = std::sqrt(std::abs(exact.second(i, i) * exact.second(j, j)));
          EXPECT_NEAR(exact.second(i, j), slope(along, difference_step[i]), 1e-8 * scale);
        }
      }
    }
  }
}

TEST(Section, RestIsExactAndSmallStatesAreAccurate) {
  std::printf("seed 14\n");
  Random random(14);
  for (const Case& example : cases) {
    const Prepared p = prepare(example);
    const SectionEnergy rest = energy(p, {});
    EXPECT_EQ(rest.value, 0);
    for (const double g : rest.gradient) EXPECT_EQ(g, 0);
    // Far below the rounding of 1 + strain, energy and gradient still follow the rest Hessian.
    for (int trial = 0; trial < 5; ++trial) {
      const std::array<double, 3> q = {random.between(-1, 1) * 1e-13, random.between(-1, 1) * 1e-14,
                                       random.between(-1, 1) * 1e-12};
      const SectionEnergy small = energy(p, {q[0], q[1], q[2]});
      double value = 0;
      for (int i = 0; i < 3; ++i) {
        double gradient = 0;
        double size = 0;
        for (int j = 0; j < 3; ++j) {
          gradient += rest.second(i, j) * q[j];
          size += std::abs(rest.second(i, j) * q[j]);
        }
        EXPECT_NEAR(small.gradient[i], gradient, 1e-10 * size);
        value += 0.5 * gradient * q[i];
      }
      EXPECT_NEAR(small.value, value, 1e-9 * value);
    }
  }
}

TEST(Section, CavityGrowth) {
  const Section section = prepare_section(tube(14, 18, NeoHookean{0.08}), {});
  const SectionEnergy growth = cavity_growth(section, {0.3, 0.01, 1.1});
  EXPECT_NEAR(growth.value, pi * (15.1 * 15.1 * 1.3 - 196), 1e-12 * growth.value);
  EXPECT_NEAR(growth.gradient[0], pi * 15.1 * 15.1, 1e-11);
  EXPECT_EQ(growth.gradient[1], 0);
  EXPECT_NEAR(growth.gradient[2], 2 * pi * 15.1 * 1.3, 1e-11);
  EXPECT_NEAR(growth.second(0, 2), 2 * pi * 15.1, 1e-11);
  EXPECT_NEAR(growth.second(2, 2), 2 * pi * 1.3, 1e-11);
}

TEST(Section, ImpossibleStatesHaveNoEnergy) {
  Segment segment = tube(12, 16, Gent{0.08, 3});
  const Section section = prepare_section(segment, {});
  const Quadrature quadrature = make_quadrature(section, 8, 1);
  EXPECT_FALSE(stored_energy(section, quadrature, {-1, 0, 0}));
  EXPECT_FALSE(stored_energy(section, quadrature, {0, 0, -12}));
  EXPECT_FALSE(stored_energy(section, quadrature, {std::nan(""), 0, 0}));
  // I1 - 3 at the bore with lambda = 1 is b + 1/b - 2, b = (a/R_i)^2: 3 at b = (5 + sqrt 21)/2.
  const double limit = 12 * std::sqrt((5 + std::sqrt(21.0)) / 2) - 12;
  const auto below = stored_energy(section, quadrature, {0, 0, limit * (1 - 1e-9)});
  ASSERT_TRUE(below);
  EXPECT_TRUE(std::isfinite(below->value));
  EXPECT_FALSE(stored_energy(section, quadrature, {0, 0, limit * (1 + 1e-9)}));
}

TEST(Section, FractionsAndJointsAreCounted) {
  const Section section = prepare_section(paper_segment({36}), with_joint(JointModel::clear_span));
  const double fraction = 16 / (2 * pi * 17 * std::sin(36 * degree));
  ASSERT_EQ(section.families.size(), 1U);
  EXPECT_NEAR(section.families[0].stretch_modulus_mpa, fraction * 19.46, 1e-12);
  EXPECT_NEAR(section.ring_modulus_mpa, 16.0 / 85 * 19.46, 1e-12);
  const double pitch = 83.0 / 7;
  const double expected = fraction * 19.46 * std::pow(2 * std::sin(36 * degree) / pitch, 2) *
                          std::pow(pitch / (pitch - 2), 3);
  EXPECT_NEAR(section.families[0].joint_modulus_mpa, expected, 1e-12);
}

TEST(Section, WithoutRingsThereIsNoJoint) {
  Segment segment = paper_segment({36});
  segment.lattice->rings.reset();
  for (const JointModel joint : {JointModel::paper, JointModel::clear_span}) {
    const Section section = prepare_section(segment, with_joint(joint));
    EXPECT_EQ(section.families[0].joint_modulus_mpa, 0);
    EXPECT_EQ(section.ring_modulus_mpa, 0);
  }
  segment.lattice->rings = Rings{std::nullopt, 200.0, 2};  // the first would sit at 100 of 85 mm
  const Section section = prepare_section(segment, with_joint(JointModel::paper));
  EXPECT_EQ(section.families[0].joint_modulus_mpa, 0);
  EXPECT_EQ(section.ring_modulus_mpa, 0);
}

TEST(Section, MirroredAnglesAreMirroredToTheLastBit) {
  const Section section = prepare_section(paper_segment({36, 144, 0.7, 179.3, 90}), [] {
    ModelChoice model;
    model.wall = WallKind::mixture;
    return model;
  }());
  EXPECT_EQ(section.families[0].cosine, -section.families[1].cosine);
  EXPECT_EQ(section.families[0].sine, section.families[1].sine);
  EXPECT_EQ(section.families[4].cosine, 0);
  EXPECT_EQ(section.families[4].sine, 1);
}

std::string refusal(const Segment& segment, const ModelChoice& model = {}) {
  try {
    prepare_section(segment, model);
  } catch (const UnsupportedDesign& refused) {
    return refused.what();
  }
  return "";
}

TEST(Section, TwistsUnlessEveryFamilyHasItsMirrorImage) {
  const auto twists = [](const std::vector<Grid>& grids) {
    Segment segment = paper_segment({});
    segment.lattice->grids = grids;
    return prepare_section(segment, {}).twists;
  };
  const Grid wide = grid(36, 8, 2);
  const Grid thin = grid(36, 8, 1);
  const Grid wide_image = grid(144, 8, 2);
  const Grid thin_image = grid(144, 8, 1);
  EXPECT_FALSE(twists({grid(90, 8, 2)}));
  EXPECT_FALSE(twists({wide, thin, wide_image, thin_image}));
  EXPECT_FALSE(twists({wide, wide, grid(60, 8, 1), wide_image, grid(120, 8, 1), wide_image}));
  EXPECT_TRUE(twists({wide, thin_image}));
  EXPECT_TRUE(twists({wide, wide}));
  EXPECT_TRUE(twists({wide, wide, wide_image}));
  EXPECT_TRUE(twists({wide, grid(143, 8, 2)}));
}

TEST(Section, WhatCannotBePredictedIsRefusedByName) {
  ModelChoice mixture;
  mixture.wall = WallKind::mixture;
  Segment horseshoe = paper_segment({36, 90});
  horseshoe.lattice->grids[1].path = Horseshoe{2.6, 180, true};
  EXPECT_EQ(refusal(horseshoe), "");
  EXPECT_NE(refusal(horseshoe, mixture).find("grid 2 has horseshoe strands"), std::string::npos);
  std::get<Horseshoe>(horseshoe.lattice->grids[1].path).arc_deg = 5;
  EXPECT_NE(refusal(horseshoe).find("cannot be predicted"), std::string::npos);

  Segment graded = paper_segment({36, 60});
  graded.lattice->grids[0].widths_mm[3] = 2.5;
  EXPECT_EQ(refusal(graded), "");
  EXPECT_NE(refusal(graded, mixture).find("bends"), std::string::npos);
  graded.lattice->grids[1].widths_mm[3] = 2.5;
  EXPECT_NE(refusal(graded).find("wind at different rates"), std::string::npos);

  EXPECT_NE(refusal(tube(12, 16, Linear{0.082, 0.499})).find("linear law"), std::string::npos);

  Segment rubber_lattice = paper_segment({36});
  rubber_lattice.lattice->material.law = NeoHookean{5};
  EXPECT_NE(refusal(rubber_lattice).find("lattice material"), std::string::npos);

  EXPECT_NE(refusal(paper_segment({5})).find("overlap"), std::string::npos);

  Segment touching = paper_segment({36});
  touching.lattice->rings = Rings{std::nullopt, 2.0, 2};
  EXPECT_NE(refusal(touching, with_joint(JointModel::clear_span)).find("rings touch"),
            std::string::npos);
  EXPECT_EQ(refusal(touching, with_joint(JointModel::paper)), "");
}

}  // namespace
}  // namespace latticast::testing
