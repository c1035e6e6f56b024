// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of bent sections: its derivatives against differences, and against the work done.
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/numerics/gauss.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// Central differences of 6th order.
template <class F>
double slope(const F& f, double h) {
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

Law random_rubber(Random& random) {
  switch (random.integer(0, 4)) {
    case 0:
      return NeoHookean{0.08};
    case 1:
      return Yeoh{0.04, 0.002, 0.0005};
    case 2:
      return Mooney{0.03, 0.01};
    case 3:
      return Ogden{{0.04, 0.002, -0.01}, {1.3, 5, -2}};
    default:
      return Gent{0.08, 40};
  }
}

/// One uneven family of straight or horseshoe strands at any angle, and up to two even ones.
Segment random_segment(Random& random) {
  Segment segment = paper_segment({});
  segment.liner.material.law = random_rubber(random);
  if (random.chance(0.3)) segment.lattice->rings.reset();
  const int families = random.integer(1, 3);
  for (int i = 0; i < families; ++i) {
    const double widest = i == 0 ? 3 : 1;
    std::vector<double> widths(random.integer(2, 7), random.between(0.4, widest));
    if (i == 0) {
      for (double& width : widths) width = random.between(0.4, widest);
    }
    Grid grid{random.between(30, 150), widths, StraightPath{}};
    if (random.chance(0.5)) {
      grid.path = Horseshoe{random.between(2, 4), random.between(90, 220), true};
    }
    segment.lattice->grids.push_back(grid);
  }
  return segment;
}

TEST(BentSection, DerivativesAgreeWithDifferences) {
  std::printf("seed 51\n");
  Random random(51);
  int states = 0;
  for (int design = 0; design < 40; ++design) {
    const Section section = prepare_section(random_segment(random), {});
    const Quadrature quadrature = make_quadrature(section, 5, 4, 12);
    const std::array<double, 5> step = {2e-4, 1e-5, 2e-3, 1e-5, 1e-5};
    for (int trial = 0; trial < 3; ++trial) {
      const std::array<double, 5> q = {random.between(0, 0.25), random.between(-0.008, 0.008),
                                       random.between(-0.5, 2), random.between(-0.004, 0.004),
                                       random.between(-0.004, 0.004)};
      const auto energy = [&](int i, double h) {
        std::array<double, 5> p = q;
        p[i] += h;
        return stored_energy(section, quadrature, {p[0], p[1], p[2], p[3], p[4]});
      };
      if (!energy(0, 0.01) || !energy(0, -0.01)) continue;  // near the end of a horseshoe's law
      ++states;
      const SectionEnergy exact = *energy(0, 0);
      for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE("design " + std::to_string(design) + ", coordinate " + std::to_string(i));
        const double scale = std::sqrt(exact.value * std::abs(exact.second(i, i)));
        EXPECT_NEAR(exact.gradient[i],
                    slope([&](double h) { return energy(i, h).value().value; }, step[i]),
                    1e-7 * scale);
        for (int j = 0; j < 5; ++j) {
          const double size = std::sqrt(std::abs(exact.second(i, i) * exact.second(j, j)));
          const double found =
              slope([&](double h) { return energy(i, h).value().gradient[j]; }, step[i]);
          EXPECT_NEAR(exact.second(i, j), found, 1e-6 * size) << j;
        }
      }
    }
  }
  std::printf("%d states\n", states);
  EXPECT_GT(states, 80);
}

/// Stored energy against integral P dV = P V - integral V dP along the path, the latter by Gauss
/// points in pressure.
void expect_work_is_energy(const Segment& segment, double end_kpa) {
  const PreparedSegment prepared = prepare_segment(segment, {});
  const Section& section = std::get<Section>(prepared.section);
  const Quadrature quadrature = make_quadrature(section, 24, 24, 64);
  const GaussRule rule = gauss_legendre(12);
  const int panels = 6;
  std::vector<double> pressures;
  for (int panel = 0; panel < panels; ++panel) {
    for (const double u : rule.points) {
      pressures.push_back(end_kpa * (panel + 0.5 * (1 + u)) / panels);
    }
  }
  pressures.push_back(end_kpa);
  const Response response = predict(prepared, pressures);
  ASSERT_EQ(response.status, Status::ok) << response.message;
  double beside = 0;
  for (std::size_t i = 0; i + 1 < pressures.size(); ++i) {
    const Deformation q =
        response.states[i]->deformation(section.inner_radius_mm, section.axis_rad);
    beside += rule.weights[i % 12] * end_kpa / 2000 / panels * cavity_growth(section, q).value;
  }
  const Deformation q =
      response.states.back()->deformation(section.inner_radius_mm, section.axis_rad);
  const double work = end_kpa / 1000 * cavity_growth(section, q).value - beside;
  EXPECT_GT(std::hypot(q.bend_1, q.bend_2), 1e-4);
  EXPECT_NEAR(stored_energy(section, quadrature, q)->value / work, 1, 1e-9);
}

TEST(BentSection, PressureWorkIsTheEnergyStored) {
  expect_work_is_energy(columns({2, 4, 3, 3.5, 2.5}, 70), 30);
  expect_work_is_energy(columns(halves(16, 4, 2)), 80);
  Segment straight = paper_segment({36});
  straight.lattice->grids[0].widths_mm = {2, 1.5, 1, 2.5, 3, 2, 1, 1};
  straight.lattice->grids.push_back(grid(120, 5, 1));
  expect_work_is_energy(straight, 40);
}

}  // namespace
}  // namespace latticast::testing
