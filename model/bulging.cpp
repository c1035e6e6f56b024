// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bulging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <variant>

#include "geometry/pattern/rings.h"
#include "model/inflated_wall.h"
#include "model/section.h"

namespace latticast {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double shear_factor = 5.0 / 6;  // of a rectangular section
constexpr double highest = 2;             // heights looked at, of the gap
constexpr int heights = 40;
constexpr int wall_points = 6;

/// 2 dW/dI1: Cauchy stress differences are this times differences of squared stretches.
double rubber_modulus(const Law& law, double j) {
  if (const auto* linear = std::get_if<Linear>(&law)) return linear->youngs_modulus_mpa / 3;
  if (const auto* rubber = std::get_if<NeoHookean>(&law)) return rubber->shear_modulus_mpa;
  if (const auto* rubber = std::get_if<Yeoh>(&law)) {
    return 2 * (rubber->c1_mpa + j * (2 * rubber->c2_mpa + 3 * j * rubber->c3_mpa));
  }
  const auto& gent = std::get<Gent>(law);
  return j < gent.limit_jm ? gent.shear_modulus_mpa / (1 - j / gent.limit_jm) : HUGE_VAL;
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
    modulus_mpa = rubber_modulus(patch.law, patch.invariant_minus_3 + more);
  }

  double tension() const { return modulus_mpa * (stretch_squared - across_squared) * thickness_mm; }
  double shear_stiffness() const {
    return shear_factor * modulus_mpa * across_squared * thickness_mm;
  }
  double bending_stiffness() const {
    return modulus_mpa * (stretch_squared + across_squared) * std::pow(thickness_mm, 3) / 6;
  }
};

Section rubber_alone(const Section& section) {
  Section rubber = section;
  rubber.families.clear();
  rubber.ring_modulus_mpa = 0;
  rubber.twists = true;
  return rubber;
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

/// Pressure that a section's energy bears by growing around the tube, (dPi/da)/(2 pi a lambda): the
/// same at every radius of an incompressible wall. Empty where the state cannot exist.
std::optional<double> borne_pressure_mpa(const Section& section, const Quadrature& points,
                                         const Deformation& at) {
  constexpr std::array active = {coordinate::inner_growth};
  const auto energy = stored_energy(section, points, at, active);
  if (!energy) return std::nullopt;
  const double bore = section.inner_radius_mm + at.inner_growth;
  return energy->gradient[coordinate::inner_growth] / (2 * pi * bore * (1 + at.elongation));
}

double contact_pressure_mpa(const Section& section, const State& state,
                            const std::function<void(Section&)>& leave_only) {
  Section members = rubber_alone(section);
  members.isotropic_fraction = 0;
  leave_only(members);
  const Deformation at = state.deformation(section.inner_radius_mm, section.axis_rad);
  const Quadrature points = make_quadrature(members, wall_points, wall_points);
  return borne_pressure_mpa(members, points, at).value_or(0);
}

/// What the rubber's own roundness bears as the wall comes out, on the side that is lengthened.
class RoundWall {
 public:
  RoundWall(Section rubber, const WallStretch& outside, const State& state)
      : rubber_(std::move(rubber)),
        points_(make_quadrature(rubber_, wall_points, 1)),
        rest_{outside.axial - 1, state.twist_rad_per_mm,
              state.inner_radius_mm - rubber_.inner_radius_mm, 0, 0},
        outer_mm_(current_radius_mm(rubber_.inner_radius_mm, rubber_.liner_outer_radius_mm, rest_)),
        borne_mpa_(borne(0)) {}

  /// Averaged over the gap with the bulge's own shape as the weight, a parabola.
  double gain_mpa(double height_mm) const {
    constexpr std::array<double, 3> places = {0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double shape = 1 - places[i] * places[i];
      sum += weights[i] * shape * (borne(height_mm * shape) - borne_mpa_);
    }
    return 1.5 * sum;
  }

  double borne_mpa() const { return borne_mpa_; }
  double thickness_mm() const { return outer_mm_ - rubber_.inner_radius_mm - rest_.inner_growth; }

 private:
  double borne(double out_mm) const {
    Deformation at = rest_;
    const double bore = rubber_.inner_radius_mm + rest_.inner_growth;
    at.inner_growth =
        std::sqrt(bore * bore + out_mm * (2 * outer_mm_ + out_mm)) - rubber_.inner_radius_mm;
    return borne_pressure_mpa(rubber_, points_, at).value_or(HUGE_VAL);
  }

  Section rubber_;
  Quadrature points_;
  Deformation rest_;
  double outer_mm_;
  double borne_mpa_;
};

/// Fills in height and largest load of a bulge whose gap and load are known.
void settle(Bulge& bulge, const WallPatch& patch, const RoundWall& wall) {
  if (!(bulge.load_mpa > 0) || !(bulge.gap_mm > 0)) {
    bulge.load_mpa = std::max(0.0, bulge.load_mpa);
    bulge.largest_load_mpa = HUGE_VAL;
    return;
  }
  const auto resistance = [&](double height) {
    return cap_pressure_mpa(patch, height) + wall.gain_mpa(height);
  };
  const auto height_of = [&](int i) {
    const double share = static_cast<double>(i) / heights;
    return highest * bulge.gap_mm * share * share;
  };
  std::optional<int> first;
  for (int i = 1; i <= heights; ++i) {
    const double load = resistance(height_of(i));
    bulge.largest_load_mpa = std::max(bulge.largest_load_mpa, load);
    if (!first && load >= bulge.load_mpa) first = i;
  }
  if (!first) {
    bulge.height_mm = HUGE_VAL;
    return;
  }
  double low = height_of(*first - 1);
  double high = height_of(*first);
  while (high - low > 1e-9 * bulge.gap_mm) {
    const double middle = 0.5 * (low + high);
    (resistance(middle) < bulge.load_mpa ? low : high) = middle;
  }
  bulge.height_mm = 0.5 * (low + high);
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

struct Place {
  const Segment& segment;
  const State& state;
  const RoundWall& wall;
  WallStretch middle;   ///< at half of the liner's thickness
  WallStretch outside;  ///< under the lattice

  /// `angle_rad`: of the direction across the gap, from the circumference.
  WallPatch patch(double span_mm, double angle_rad) const {
    const double around = std::cos(angle_rad);
    const double along = std::sin(angle_rad);
    WallPatch patch;
    patch.law = segment.liner.material.law;
    patch.span_mm = span_mm;
    patch.thickness_mm = wall.thickness_mm();
    patch.stretch_squared = std::pow(middle.hoop * around, 2) +
                            std::pow(middle.shear * around + middle.axial * along, 2);
    patch.across_wall = middle.across();
    patch.invariant_minus_3 = middle.first_invariant_minus_3();
    patch.tension_n_per_mm = std::max(0.0, Stretched(patch, 1).tension());
    return patch;
  }
};

/// All that the wall carries along the tube: pressure on the closed ends, and the mounting's pull.
double end_tension_n_per_mm(const Segment& segment, const State& state) {
  const double bore = state.inner_radius_mm;
  const double pull = state.pressure_kpa / 1000 * pi * bore * bore + state.force_n;
  const double outer = wall_stretch(segment, state, segment.liner_outer_radius_mm(), 0).radius_mm;
  return std::max(0.0, pull / (2 * pi * outer));
}

std::optional<Bulge> between_rings(const Place& place, double load_mpa) {
  const Segment& segment = place.segment;
  if (!segment.lattice->rings) return std::nullopt;
  const Rings& rings = *segment.lattice->rings;
  if (ring_centres_mm(rings, segment.length_mm).size() < 2) return std::nullopt;
  Bulge bulge;
  bulge.members = "rings";
  const double pitch = ring_pitch_mm(rings, segment.length_mm);
  bulge.gap_mm = std::max(0.0, place.outside.axial * pitch - rings.width_mm);
  bulge.load_mpa = load_mpa;
  WallPatch patch = place.patch(bulge.gap_mm, pi / 2);
  patch.tension_n_per_mm = end_tension_n_per_mm(segment, place.state);
  settle(bulge, patch, place.wall);
  return bulge;
}

Bulge between_strands(const Place& place, const Section& section, std::size_t grid,
                      const WallStretch& layer) {
  const Grid& strands = place.segment.lattice->grids[grid];
  const double angle = strands.angle_deg * pi / 180;
  Bulge bulge;
  bulge.members = "grid " + std::to_string(grid);
  bulge.gap_mm = widest_strand_gap_mm(strands, layer, angle);
  bulge.load_mpa = contact_pressure_mpa(
      section, place.state, [&](Section& only) { only.families = {section.families[grid]}; });
  settle(bulge, place.patch(bulge.gap_mm, layer.turned_rad(angle) + pi / 2), place.wall);
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
  const auto* section = std::get_if<Section>(&prepared.section);
  const double side = lengthened_side_rad(state);
  const auto at = [&](double radius) { return wall_stretch(segment, state, radius, side); };
  const double middle = segment.inner_radius_mm() + 0.5 * segment.liner.thickness_mm;
  const WallStretch outside = at(segment.liner_outer_radius_mm());
  const RoundWall wall(
      std::visit([](const auto& kind) { return rubber_alone(kind); }, prepared.section), outside,
      state);
  const Place place{segment, state, wall, at(middle), outside};

  std::vector<Bulge> bulges;
  // Effective rods leave all roundness to the rings.
  const double ring_load =
      section ? contact_pressure_mpa(
                    *section, state,
                    [&](Section& only) { only.ring_modulus_mpa = section->ring_modulus_mpa; })
              : state.pressure_kpa / 1000 - wall.borne_mpa();
  if (auto bulge = between_rings(place, ring_load)) bulges.push_back(std::move(*bulge));
  if (section == nullptr) return bulges;
  for (std::size_t i = 0; i < section->families.size(); ++i) {
    bulges.push_back(between_strands(place, *section, i, at(segment.lattice_mid_radius_mm())));
  }
  return bulges;
}

}  // namespace latticast
