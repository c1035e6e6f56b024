// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/atlas_designs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "design/units.h"
#include "tests/random_numbers.h"

namespace latticast {
namespace {

/// Rising, evenly spaced in the logarithm.
std::vector<double> decades(double low, double high, int count) {
  std::vector<double> values(count);
  for (int i = 0; i < count; ++i) values[i] = low * std::pow(high / low, i / (count - 1.0));
  return values;
}

/// From 0.01 to 179.99 degrees, dense at both ends.
std::vector<double> angles(int count) {
  std::vector<double> values(count);
  for (int i = 0; i < count; ++i) {
    const double u = 2.0 * i / (count - 1) - 1;
    const double from_axis = 90 * (1 - std::pow(10, -4 * std::abs(u)) + std::abs(u) * 0);
    values[i] = u == 0 ? 90 : 90 + std::copysign(from_axis * (89.99 / 89.991), u);
  }
  return values;
}

/// The same for R_i/R_m, dense at thin walls.
std::vector<double> wall_ratios(int count) {
  std::vector<double> values = decades(1e-3, 0.95, count);
  for (double& value : values) value = 1 - value;
  std::reverse(values.begin(), values.end());
  return values;
}

Segment twisting_segment(double stiffness_ratio = 243.25) {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  segment.liner.material.law = NeoHookean{0.08};
  Lattice lattice;
  lattice.thickness_mm = 2;
  lattice.material.law = Linear{0.08 * stiffness_ratio, 0.5};
  lattice.rings = Rings{8, std::nullopt, 2};
  segment.lattice = lattice;
  return segment;
}

std::vector<double> halves(int count, double thick, double thin) {
  std::vector<double> widths(count, thin);
  for (int j = 0; 2 * j < count; ++j) widths[j] = thick;
  return widths;
}

using MapSegment = Segment (*)(double);

/// Pressure along y, in units of each segment's own reference.
AtlasMap pressure_map(const std::string& name, AtlasAxis x, int per_axis, MapSegment segment) {
  AtlasMap map{name, std::move(x), {"pressure over reference", decades(0.01, 100, per_axis)}, {}};
  for (const double value : map.x.values) {
    AtlasDesign design{segment(value), {}, {}, {}};
    const double reference = reference_pressure_kpa(design);
    for (const double ratio : map.y.values) {
      design.pressures_kpa = {ratio * reference};
      map.designs.push_back(design);
    }
  }
  return map;
}

Segment stiff_segment(double stiffness_ratio) {
  Segment segment = twisting_segment(stiffness_ratio);
  segment.lattice->grids.push_back({36, std::vector<double>(8, 2.0), StraightPath{}});
  return segment;
}

Segment horseshoe_segment(double slenderness) {
  Segment segment = twisting_segment();
  const double width = 2;
  segment.lattice->grids.push_back(
      {90, halves(16, width, 0.8 * width), Horseshoe{width / slenderness, 180, true}});
  return segment;
}

Segment graded_segment(double width_ratio) {
  Segment segment = twisting_segment();
  segment.lattice->grids.push_back({60, halves(16, 0.003 * width_ratio, 0.003), StraightPath{}});
  return segment;
}

AtlasMap wall_map(int per_axis) {
  AtlasMap map{"wall",
               {"inner over outer radius of the wall", wall_ratios(per_axis)},
               {"angle, degrees", angles(per_axis)},
               {}};
  for (const double ratio : map.x.values) {
    for (const double angle : map.y.values) {
      AtlasDesign design{twisting_segment(), {}, {}, {}};
      design.segment.liner.inner_radius_mm = 16 * ratio;
      design.segment.liner.thickness_mm = 16 * (1 - ratio);
      const double room = 2 * pi * 17 * std::sin(angle * pi / 180);
      design.segment.lattice->grids.push_back(
          {angle, std::vector<double>(8, std::min(2.0, 0.5 * room / 8)), StraightPath{}});
      design.pressures_kpa = {0.5 * reference_pressure_kpa(design)};
      map.designs.push_back(design);
    }
  }
  return map;
}

Law random_rubber(testing::Random& dice, double mu) {
  switch (dice.integer(0, 2)) {
    case 0:
      return NeoHookean{mu};
    case 1:
      return Yeoh{mu / 2, mu * dice.between(-0.02, 0.1), mu * dice.between(0, 0.02)};
    default:
      return Gent{mu, dice.log_between(1, 500)};
  }
}

double random_angle(testing::Random& dice) {
  if (dice.chance(0.2)) return 90;
  if (dice.chance(0.3)) {
    const double from_end = dice.log_between(0.01, 10);
    return dice.chance(0.5) ? from_end : 180 - from_end;
  }
  return dice.between(5, 175);
}

std::vector<double> random_widths(testing::Random& dice, int count, double room_mm) {
  const double widest = room_mm / count * dice.log_between(1e-3, 0.95);
  std::vector<double> widths(count, widest);
  if (!dice.chance(0.25) || count > 200) return widths;
  const double thin = widest / dice.log_between(1, 1000);
  if (dice.chance(0.7)) return halves(count, widest, thin);
  for (double& width : widths) width = dice.log_between(thin, widest);
  return widths;
}

Grid random_grid(testing::Random& dice, double middle_mm, bool axial) {
  Grid grid;
  grid.angle_deg = axial ? 90 : random_angle(dice);
  const int count = dice.chance(0.1)   ? 1
                    : dice.chance(0.1) ? static_cast<int>(dice.log_between(100, 5000))
                                       : dice.integer(2, 24);
  const double room = 2 * pi * middle_mm * std::sin(grid.angle_deg * pi / 180);
  grid.widths_mm = random_widths(dice, count, room);
  if (count <= 24 && dice.chance(axial ? 0.6 : 0.15)) {
    const double slenderness = dice.log_between(1e-3, 100);
    grid.path = Horseshoe{grid.widths_mm.front() / slenderness, dice.between(20, 300), true};
  }
  return grid;
}

Lattice random_lattice(testing::Random& dice, const Segment& segment, double modulus, bool axial) {
  Lattice lattice;
  lattice.thickness_mm = segment.liner_outer_radius_mm() * dice.log_between(1e-3, 1);
  lattice.material.law = Linear{modulus, 0.5};
  if (dice.chance(0.7)) {
    const int count =
        dice.chance(0.1) ? static_cast<int>(dice.log_between(100, 5000)) : dice.integer(2, 30);
    lattice.rings =
        Rings{count, std::nullopt, segment.length_mm / count * dice.log_between(1e-3, 0.98)};
  }
  const double middle = segment.liner_outer_radius_mm() + 0.5 * lattice.thickness_mm;
  const int families = dice.integer(lattice.rings ? 0 : 1, axial ? 1 : 3);
  for (int i = 0; i < families; ++i) lattice.grids.push_back(random_grid(dice, middle, axial));
  return lattice;
}

}  // namespace

std::vector<AtlasMap> atlas_maps(int per_axis) {
  return {pressure_map("stiffness", {"E over mu", decades(1e-3, 1e9, per_axis)}, per_axis,
                       stiff_segment),
          wall_map(per_axis),
          pressure_map("horseshoe", {"width over radius of arcs", decades(1e-3, 100, per_axis)},
                       per_axis, horseshoe_segment),
          pressure_map("widths", {"width ratio of both halves", decades(1, 1000, per_axis)},
                       per_axis, graded_segment)};
}

AtlasDesign random_atlas_design(unsigned seed, int index) {
  testing::Random dice(seed, index);
  AtlasDesign design;
  const bool rods = dice.chance(0.08);
  design.model.columns = rods ? ColumnModel::rods : ColumnModel::distributed;
  design.model.wall = dice.chance(0.1) && !rods ? WallKind::mixture : WallKind::layered;
  design.model.joint = static_cast<JointModel>(dice.integer(0, 2));
  design.held = {dice.chance(0.15), dice.chance(0.15), dice.chance(0.15)};
  const double outer = dice.log_between(0.1, 1000);
  const double ratio =
      dice.chance(0.3) ? 1 - dice.log_between(1e-3, 0.2) : dice.between(0.05, 0.999);
  const double mu = dice.log_between(1e-3, 10);
  design.segment.length_mm = dice.log_between(1e-2, 1e5);
  design.segment.liner.inner_radius_mm = outer * ratio;
  design.segment.liner.thickness_mm = outer * (1 - ratio);
  design.segment.liner.material.law = random_rubber(dice, mu);
  if (rods || dice.chance(0.93)) {
    const double modulus = mu * dice.log_between(1e-3, 1e9);
    design.segment.lattice = random_lattice(dice, design.segment, modulus, rods);
  }
  const double sign = dice.chance(0.3) ? -1 : 1;
  design.pressures_kpa = {1};
  const double reference =
      dice.chance(0.5) ? fitting_pressure_kpa(design) : reference_pressure_kpa(design);
  const double factor = dice.log_between(1e-2, 100);
  design.pressures_kpa = {sign * reference * factor * dice.between(0.02, 1),
                          sign * reference * factor};
  return design;
}

std::string description(const AtlasDesign& design) {
  const Segment& s = design.segment;
  char text[400];
  std::snprintf(text, sizeof text,
                "wall %.17g + %.17g, length %.17g, law %zu, columns %d, kind %d, joint %d, held "
                "%d%d%d, first pressure %.17g kPa",
                s.liner.inner_radius_mm, s.liner.thickness_mm, s.length_mm,
                s.liner.material.law.index(), static_cast<int>(design.model.columns),
                static_cast<int>(design.model.wall), static_cast<int>(design.model.joint),
                design.held.stretch, design.held.twist, design.held.bend,
                design.pressures_kpa.front());
  std::string result = text;
  if (!s.lattice) return result;
  std::snprintf(text, sizeof text, "; lattice %.17g, %d rings %.17g, E %g", s.lattice->thickness_mm,
                s.lattice->rings ? s.lattice->rings->count.value_or(0) : 0,
                s.lattice->rings ? s.lattice->rings->width_mm : 0,
                std::get<Linear>(s.lattice->material.law).youngs_modulus_mpa);
  result += text;
  for (const Grid& grid : s.lattice->grids) {
    const auto* horseshoe = std::get_if<Horseshoe>(&grid.path);
    std::snprintf(text, sizeof text, "; %d at %.17g, widths %.17g to %.17g, R_h %.17g arc %.17g",
                  grid.count(), grid.angle_deg, grid.widths_mm.front(), grid.widths_mm.back(),
                  horseshoe != nullptr ? horseshoe->radius_mm : 0,
                  horseshoe != nullptr ? horseshoe->arc_deg : 0);
    result += text;
  }
  return result;
}

}  // namespace latticast
