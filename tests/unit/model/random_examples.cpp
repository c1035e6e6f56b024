// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/model/random_examples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace latticast::testing {
namespace {

Law random_rubber(Random& random, double mu, double least_gent_limit) {
  switch (random.integer(0, 2)) {
    case 0:
      return NeoHookean{mu};
    case 1:
      return Yeoh{mu / 2, mu * random.between(-0.02, 0.1), mu * random.between(0, 0.02)};
    default:
      return Gent{mu, random.log_between(least_gent_limit, 200)};
  }
}

Lattice random_lattice(Random& random, const Segment& segment, double modulus) {
  const double middle = segment.liner_outer_radius_mm();
  Lattice lattice;
  lattice.thickness_mm = middle * random.log_between(1e-3, 0.5);
  lattice.material.law = Linear{modulus, 0.5};
  if (random.chance(0.7)) {
    const double width = random.between(0.5, 3);
    const int most = static_cast<int>(0.9 * segment.length_mm / width);
    lattice.rings = Rings{random.integer(2, most), std::nullopt, width};
  }
  const int families = random.integer(0, 3);
  for (int i = 0; i < families; ++i) {
    const double angle = random.between(0.5, 179.5);
    const int count = std::max(2, random.integer(1, 20));  // a single strand would bend
    const double room = 2 * pi * (middle + 0.5 * lattice.thickness_mm) * std::sin(angle * degree);
    lattice.grids.push_back(grid(angle, count, room / count * random.between(0.02, 0.9)));
  }
  return lattice;
}

/// Halves, a cosine round the tube, or any of three widths anywhere.
std::vector<double> random_widths(Random& random, int count, double widest) {
  const double thin = widest * random.between(0.1, 1);
  if (random.chance(0.4)) return halves(count, widest, thin);
  std::vector<double> widths;
  const std::array<double, 3> few = {thin, 0.5 * (thin + widest), widest};
  for (int j = 0; j < count; ++j) widths.push_back(few[random.integer(0, 2)]);
  return widths;
}

}  // namespace

RandomExample random_straight_example(Random& random) {
  RandomExample example;
  const double outer = random.log_between(1, 50);
  const double ratio =
      random.chance(0.3) ? 1 - random.log_between(1e-3, 0.2) : random.between(0.05, 0.999);
  const double mu = random.log_between(1e-3, 10);
  const double modulus = mu * random.log_between(1e-3, 1e7);
  example.segment = tube(outer * ratio, outer, random_rubber(random, mu, 2));
  example.segment.length_mm = random.between(20, 300);
  double pressure = mu * (1 - ratio) * random.log_between(0.01, 3);
  if (random.chance(0.9)) {
    example.segment.lattice = random_lattice(random, example.segment, modulus);
    if (random.chance(0.4)) {
      pressure += modulus * 0.1 * random.log_between(1e-3, 1) *
                  example.segment.lattice->thickness_mm / outer;
    }
  }
  example.model.wall = random.chance(0.15) ? WallKind::mixture : WallKind::layered;
  example.model.joint = static_cast<JointModel>(random.integer(0, 2));
  example.held = {random.chance(0.2), random.chance(0.2)};
  const int count = random.integer(1, 13);
  for (int i = 1; i <= count; ++i) example.pressures_kpa.push_back(1000 * pressure * i / count);
  if (random.chance(0.4)) example.pressures_kpa.push_back(-300 * pressure);
  return example;
}

RandomExample random_bending_example(Random& random) {
  RandomExample example;
  const double outer = random.log_between(2, 40);
  const double ratio = random.between(0.3, 0.97);
  const double mu = random.log_between(0.01, 1);
  Segment& segment = example.segment;
  segment = tube(outer * ratio, outer, random_rubber(random, mu, 5));
  segment.length_mm = outer * random.between(2, 20);
  Lattice lattice;
  lattice.thickness_mm = outer * random.log_between(0.01, 0.3);
  lattice.material.law = Linear{mu * random.log_between(1, 1e4), 0.5};
  const double middle = outer + 0.5 * lattice.thickness_mm;
  if (random.chance(0.6)) lattice.rings = Rings{std::nullopt, 0.5 * outer, 0.1 * outer};
  const int families = random.integer(1, 3);
  for (int i = 0; i < families; ++i) {
    const double angle = random.chance(0.3) ? 90 : random.between(10, 170);
    const int count = random.integer(i == 0 ? 1 : 2, 10);
    const double room = 2 * pi * middle * std::sin(angle * degree) / count;
    Grid grid{angle, std::vector<double>(count, room * random.between(0.02, 0.5)), StraightPath{}};
    if (i == 0) grid.widths_mm = random_widths(random, count, grid.widths_mm[0]);
    if (random.chance(0.5)) {
      grid.path =
          Horseshoe{room * random.between(0.2, 2), random.between(30, 260), random.chance(0.5)};
    }
    lattice.grids.push_back(grid);
  }
  segment.lattice = lattice;
  example.held = {random.chance(0.15), random.chance(0.15), random.chance(0.1)};
  const double pressure = 1000 * mu * (1 - ratio) * random.log_between(0.01, 3);
  const int count = random.integer(1, 5);
  for (int i = 1; i <= count; ++i) example.pressures_kpa.push_back(pressure * i / count);
  if (random.chance(0.3)) example.pressures_kpa.push_back(-0.2 * pressure);
  return example;
}

}  // namespace latticast::testing
