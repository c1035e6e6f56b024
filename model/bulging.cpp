// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bulging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <variant>

#include "design/units.h"
#include "geometry/pattern/rings.h"
#include "model/section/section_energy.h"
#include "model/shape/inflated_wall.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr double shear_factor = 5.0 / 6;  // of a rectangular section
constexpr double highest_by_gap = 2;      // heights looked at
constexpr double highest_by_radius = 4;
constexpr int heights = 24;
constexpr int most_bulge_iterations = 40;
constexpr int wall_points = 6;

/// (sigma_n - sigma_r)/(s_n^2 - s_r^2), n across the gap and r across the wall, in the plane of
/// these two; 2 dW/dI1 where the law depends on I1 = `j` + 3 alone. What shears the plane of the
/// wall counts as distortion of this one, so that I1 is that of the wall.
double rubber_modulus(const Law& law, double stretch_squared, double across_squared, double j) {
  if (!(j < first_invariant_limit(law))) return HUGE_VAL;
  InPlaneStretch at{std::sqrt(stretch_squared * across_squared) - 1, 0};
  at.distortion = std::max(0.0, j - first_invariant_minus_3(at).value);
  return 2 * energy_density(law, at).by_distortion;
}

/// The strip after it has become `longer` times as long across the gap, its edges held.
struct Stretched {
  double modulus_mpa, stretch_squared, across_squared, thickness_mm;

  Stretched(const WallPatch& patch, double longer)
      : stretch_squared(patch.stretch_squared * longer * longer),
        across_squared(patch.across_wall * patch.across_wall / (longer * longer)),
        thickness_mm(patch.thickness_mm / longer) {
    const double more = stretch_squared - patch.stretch_squared + across_squared -
                        patch.across_wall * patch.across_wall;
    modulus_mpa =
        rubber_modulus(patch.law, stretch_squared, across_squared, patch.invariant_minus_3 + more);
  }

  double tension() const { return modulus_mpa * (stretch_squared - across_squared) * thickness_mm; }
  double shear_stiffness() const {
    return shear_factor * modulus_mpa * across_squared * thickness_mm;
  }
  double bending_stiffness() const {
    return modulus_mpa * (stretch_squared + across_squared) * std::pow(thickness_mm, 3) / 6;
  }
};

Section without_rings(Section section) {
  section.ring_modulus_mpa = 0;
  return section;
}

Section rubber_alone(Section section) {
  section.families.clear();
  return without_rings(std::move(section));
}

/// A wall as a liner of the paper's rods model has it: linear, hence neo-Hookean here.
Section rubber_alone(const Rods& rods) {
  Section rubber;
  rubber.inner_radius_mm = rods.inner_radius_mm;
  rubber.liner_outer_radius_mm = rods.liner_outer_radius_mm;
  rubber.outer_radius_mm = rods.outer_radius_mm;
  rubber.isotropic_from_mm = rods.inner_radius_mm;
  rubber.isotropic_to_mm = rods.liner_outer_radius_mm;
  rubber.anisotropic_from_mm = rubber.anisotropic_to_mm = rods.liner_outer_radius_mm;
  rubber.shear_modulus_mpa = rods.youngs_modulus_mpa / 3;
  rubber.liner_law = NeoHookean{rubber.shear_modulus_mpa};
  return rubber;
}

/// Pressure that members take off the wall by being wider, (dPi/da)/(2 pi a lambda): the same at
/// every radius of an incompressible wall. `members`: a section with nothing else in it.
double contact_pressure_mpa(Section members, const State& state) {
  members.isotropic_fraction = 0;
  const Deformation at = state.deformation(members.inner_radius_mm, members.axis_rad);
  constexpr std::array active = {coordinate::inner_growth};
  const auto energy = stored_energy(members, make_quadrature(members, 1, wall_points), at, active);
  if (!energy) return 0;
  return energy->gradient[coordinate::inner_growth] /
         (2 * pi * state.inner_radius_mm * state.stretch);
}

/// Pressure that a wall carries by being round when it bulges between members, on the side that
/// bending lengthens (docs/bulging.md#what-holds).
class RoundWall {
 public:
  /// `alone`: the stretch of the wall between its edges follows from the axial balance, pressure on
  /// the closed ends against the wall's tension; otherwise it is the section's.
  RoundWall(Section wall, const WallStretch& outside, const State& state, bool alone)
      : wall_(std::move(wall)),
        points_(make_quadrature(wall_, wall_points, wall_points)),
        rest_{outside.axial - 1, state.twist_rad_per_mm,
              state.inner_radius_mm - wall_.inner_radius_mm, 0, 0},
        outer_mm_(current_radius_mm(wall_.inner_radius_mm, wall_.liner_outer_radius_mm, rest_)),
        pressure_mpa_(mpa_from_kpa(state.pressure_kpa)),
        force_n_(state.force_n),
        alone_(alone) {}

  /// Pressure carried with a parabolic bulge of this height in mid gap. Weighted with its own
  /// shape, such a bulge acts to first order like a tube that is wider by 0.8 of the height
  /// everywhere. HUGE_VAL where a strand or the rubber reaches the end of its law, -HUGE_VAL where
  /// no stretch balances the axial pull.
  double borne_mpa(double height_mm) const {
    const double outer_squared = std::pow(outer_mm_ + 0.8 * height_mm, 2);
    const double rubber =
        std::pow(wall_.liner_outer_radius_mm, 2) - std::pow(wall_.inner_radius_mm, 2);
    Deformation at = rest_;
    for (int iteration = 0; iteration < most_bulge_iterations; ++iteration) {
      const double stretch = 1 + at.elongation;
      const double bore = std::sqrt(outer_squared - rubber / stretch);
      at.inner_growth = bore - wall_.inner_radius_mm;
      const auto energy = stored_energy(wall_, points_, at, active);
      if (!energy) return HUGE_VAL;
      const double tension = energy->gradient[coordinate::elongation];
      const double off = tension - pressure_mpa_ * pi * bore * bore - force_n_;
      if (!alone_ || std::abs(off) <= 1e-10 * std::abs(tension)) {
        return energy->gradient[coordinate::inner_growth] / (2 * pi * bore * stretch);
      }
      const double bore_by_stretch = 0.5 * rubber / (bore * stretch * stretch);
      const double slope =
          energy->second(coordinate::elongation, coordinate::elongation) +
          bore_by_stretch * (energy->second(coordinate::elongation, coordinate::inner_growth) -
                             2 * pi * pressure_mpa_ * bore);
      const double step = slope > 0 ? -off / slope : 0.2 * stretch;
      at.elongation += std::clamp(step, -0.2 * stretch, 0.2 * stretch);
    }
    return -HUGE_VAL;
  }

  double thickness_mm() const { return outer_mm_ - wall_.inner_radius_mm - rest_.inner_growth; }

 private:
  static constexpr std::array active = {coordinate::elongation, coordinate::inner_growth};

  Section wall_;
  Quadrature points_;
  Deformation rest_;
  double outer_mm_;
  double pressure_mpa_;
  double force_n_;
  bool alone_;
};

struct Sample {
  double height_mm, value;
};

/// Where a function with a single hump is largest, by golden section.
Sample hump(const std::function<double(double)>& function, double low, double high) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  Sample largest{low, -HUGE_VAL};
  for (int i = 0; i < 16; ++i) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    const double at_left = function(left);
    const double at_right = function(right);
    if (at_left > largest.value) largest = {left, at_left};
    if (at_right > largest.value) largest = {right, at_right};
    (at_left < at_right ? low : high) = at_left < at_right ? left : right;
  }
  return largest;
}

/// Fills in height and largest load. `surplus`: what a bulge of a height bears beyond what it has
/// to. Where it stops rising, the bulge goes on growing by itself.
void settle(Bulge& bulge, double radius_mm, const std::function<double(double)>& surplus) {
  bulge.largest_load_mpa = HUGE_VAL;
  if (!(bulge.load_mpa > 0) || bulge.gap_mm == 0) return;
  const double highest = std::min(highest_by_gap * bulge.gap_mm, highest_by_radius * radius_mm);
  const auto height_of = [&](int i) {
    const double share = static_cast<double>(i) / heights;
    return highest * share * share;
  };
  double below = surplus(0);
  Sample largest{0, below};
  bool found = below >= 0;
  for (int i = 1; i <= heights; ++i) {
    const double above = surplus(height_of(i));
    if (!found && above >= 0) {
      found = true;
      bulge.height_mm = bracketed_root(surplus, height_of(i - 1), below, height_of(i), above,
                                       1e-9 * height_of(i));
    }
    if (above < below) {
      largest = hump(surplus, height_of(std::max(0, i - 2)), height_of(i));
      break;
    }
    largest = {height_of(i), above};
    below = above;
  }
  bulge.largest_load_mpa = bulge.load_mpa + largest.value;
  // A load may also lie between the highest sample and the top.
  if (!found) bulge.height_mm = largest.value >= 0 ? largest.height_mm : HUGE_VAL;
}

/// The widest clear distance between neighbouring strands, square to them, as they lie now.
double widest_strand_gap_mm(const Grid& grid, const WallStretch& at, double angle_rad) {
  const int n = grid.count();
  double widths = HUGE_VAL;
  for (int j = 0; j < n; ++j) {
    widths = std::min(widths, 0.5 * (grid.widths_mm[j] + grid.widths_mm[(j + 1) % n]));
  }
  const double spacing = 2 * pi * at.radius_mm / n * std::sin(at.turned_rad(angle_rad));
  return std::max(0.0, spacing - widths);
}

/// The lengthened side of an inflated segment.
struct Place {
  const Segment& segment;
  const State& state;
  WallStretch middle;   ///< at half of the liner's thickness
  WallStretch outside;  ///< under the lattice
  WallStretch layer;    ///< at the lattice's mid radius
};

/// `angle_rad`: of the direction across the gap, from the circumference.
WallPatch wall_patch(const Place& place, const RoundWall& wall, double span_mm, double angle_rad) {
  const WallStretch& at = place.middle;
  const double around = std::cos(angle_rad);
  const double along = std::sin(angle_rad);
  WallPatch patch;
  patch.law = place.segment.liner.material.law;
  patch.span_mm = span_mm;
  patch.thickness_mm = wall.thickness_mm();
  patch.stretch_squared =
      std::pow(at.hoop * around, 2) + std::pow(at.shear * around + at.axial * along, 2);
  patch.across_wall = at.across();
  patch.invariant_minus_3 = at.first_invariant_minus_3();
  patch.tension_n_per_mm = std::max(0.0, Stretched(patch, 1).tension());
  return patch;
}

/// All that the wall carries along the tube: pressure on the closed ends, and the mounting's pull.
double end_tension_n_per_mm(const Segment& segment, const State& state) {
  const double bore = state.inner_radius_mm;
  const double pull = mpa_from_kpa(state.pressure_kpa) * pi * bore * bore + state.force_n;
  const double outer = wall_stretch(segment, state, segment.liner_outer_radius_mm(), 0).radius_mm;
  return std::max(0.0, pull / (2 * pi * outer));
}

bool has_ring_gaps(const Segment& segment) {
  return segment.lattice->rings &&
         ring_centres_mm(*segment.lattice->rings, segment.length_mm).size() > 1;
}

/// Effective rods leave all that the bore's roundness does not bear to the rings.
Bulge between_rings(const Place& place, const PreparedSegment& prepared) {
  const Segment& segment = place.segment;
  const auto* section = std::get_if<Section>(&prepared.section);
  const RoundWall wall(
      section ? without_rings(*section) : rubber_alone(std::get<Rods>(prepared.section)),
      place.outside, place.state, section != nullptr);
  Bulge bulge;
  bulge.members = "rings";
  const Rings& rings = *segment.lattice->rings;
  const double pitch = ring_pitch_mm(rings, segment.length_mm);
  bulge.gap_mm = std::max(0.0, place.outside.axial * pitch - rings.width_mm);
  const double pressure = mpa_from_kpa(place.state.pressure_kpa);
  bulge.load_mpa = pressure - wall.borne_mpa(0);
  if (section) {
    Section alone = *section;
    alone.families.clear();
    bulge.load_mpa = contact_pressure_mpa(std::move(alone), place.state);
  }
  WallPatch patch = wall_patch(place, wall, bulge.gap_mm, pi / 2);
  patch.tension_n_per_mm = end_tension_n_per_mm(segment, place.state);
  settle(bulge, place.outside.radius_mm, [&](double height) {
    return cap_pressure_mpa(patch, height) + wall.borne_mpa(height) - pressure;
  });
  return bulge;
}

Bulge between_strands(const Place& place, const Section& section, std::size_t grid) {
  const Grid& strands = place.segment.lattice->grids[grid];
  const double angle = strands.angle_rad();
  const RoundWall wall(rubber_alone(section), place.outside, place.state, false);
  Bulge bulge;
  bulge.members = grid_name(grid);
  bulge.gap_mm = widest_strand_gap_mm(strands, place.layer, angle);
  Section alone = without_rings(section);
  alone.families = {section.families[grid]};
  bulge.load_mpa = contact_pressure_mpa(std::move(alone), place.state);
  const WallPatch patch =
      wall_patch(place, wall, bulge.gap_mm, place.layer.turned_rad(angle) + pi / 2);
  const double borne = wall.borne_mpa(0) + bulge.load_mpa;
  settle(bulge, place.outside.radius_mm, [&](double height) {
    return cap_pressure_mpa(patch, height) + wall.borne_mpa(height) - borne;
  });
  return bulge;
}

}  // namespace

double cap_pressure_mpa(const WallPatch& patch, double height_mm) {
  const double b = patch.span_mm;
  const double half = 2 * std::atan(2 * height_mm / b);  // of the cap's angle
  const double longer = half > 1e-6 ? half / std::sin(half) : 1 + half * half / 6;
  const Stretched now(patch, longer);
  if (!std::isfinite(now.modulus_mpa)) return HUGE_VAL;
  const double tension = patch.tension_n_per_mm + now.tension() - Stretched(patch, 1).tension();
  const double plate =
      b * b / (8 * now.shear_stiffness()) + std::pow(b, 4) / (384 * now.bending_stiffness());
  return 2 * std::sin(half) / b * tension + height_mm / plate;
}

std::vector<Bulge> liner_bulges(const Segment& segment, const PreparedSegment& prepared,
                                const State& state) {
  if (!segment.lattice) return {};
  const double side = lengthened_side_rad(state);
  const auto at = [&](double radius) { return wall_stretch(segment, state, radius, side); };
  const double middle = segment.inner_radius_mm() + 0.5 * segment.liner.thickness_mm;
  const Place place{segment, state, at(middle), at(segment.liner_outer_radius_mm()),
                    at(segment.lattice_mid_radius_mm())};
  std::vector<Bulge> bulges;
  if (has_ring_gaps(segment)) bulges.push_back(between_rings(place, prepared));
  const auto* section = std::get_if<Section>(&prepared.section);
  if (section == nullptr) return bulges;
  for (std::size_t i = 0; i < section->families.size(); ++i) {
    bulges.push_back(between_strands(place, *section, i));
  }
  return bulges;
}

}  // namespace latticast
